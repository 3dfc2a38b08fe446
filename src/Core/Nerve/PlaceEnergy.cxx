/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/PlaceEnergy.h"

#include <algorithm>

namespace tissue
{
namespace
{
VertexQuadruple
Ascending(VertexQuadruple t)
{
  // A sorting network: this is called for each tetrahedron of each proposal.
  const auto order = [&](int i, int j) {
    if (t[j] < t[i])
    {
      std::swap(t[i], t[j]);
    }
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  return t;
}

/** How the numbers of some tuples change, each tuple once. */
template <typename TKey>
class Changes
{
public:
  struct Change
  {
    TKey         key;
    std::int32_t change;
  };

  void
  Add(const TKey & key, std::int32_t change)
  {
    const auto at = std::find_if(m_Changes.begin(), m_Changes.end(), [&](const Change & c) { return c.key == key; });
    if (at == m_Changes.end())
    {
      m_Changes.push_back({ key, change });
    }
    else
    {
      at->change += change;
    }
  }

  const GeneralMove::List<Change> &
  Get() const
  {
    return m_Changes;
  }

private:
  GeneralMove::List<Change> m_Changes;
};

Changes<VertexQuadruple>
ChangesOfCorners(const GeneralComplex & complex, const GeneralMove & move)
{
  Changes<VertexQuadruple> changes;
  for (const TetrahedronId id : move.removed)
  {
    changes.Add(Ascending(complex.GetTetrahedron(id).vertices), -1);
  }
  for (const GeneralMove::NewTetrahedron & t : move.created)
  {
    changes.Add(Ascending(t.vertices), 1);
  }
  return changes;
}

Changes<VertexPair>
ChangesOfWalls(const GeneralMove & move)
{
  Changes<VertexPair> changes;
  for (const VertexPair & edge : move.removedEdges)
  {
    changes.Add(edge, -1);
  }
  for (const VertexPair & edge : move.createdEdges)
  {
    changes.Add(edge, 1);
  }
  return changes;
}

template <typename TCounts, typename TKey>
double
DifferenceOf(const TCounts & counts, const Changes<TKey> & changes)
{
  double difference = 0.0;
  for (const auto & [key, change] : changes.Get())
  {
    const auto entry = counts.Get(key);
    difference += std::abs(entry.present + change - entry.wanted) - std::abs(entry.present - entry.wanted);
  }
  return difference;
}

template <std::size_t VLength>
double
TotalOf(const TupleCounts<VLength> & counts)
{
  double total = 0.0;
  for (const auto & entry : counts.GetEntries())
  {
    total += std::abs(entry.present - entry.wanted);
  }
  return total;
}
} // namespace

PlaceEnergy::PlaceEnergy(const TissuePlaces & places, const PlacePreferences & preferences,
                         const GeneralComplex & complex)
  : m_WallWeight(preferences.wallWeight)
{
  VertexPair last{ { -1, -1 } };
  for (const ImageWall & wall : places.walls)
  {
    // The largest wall of two cells comes first.
    m_Walls[wall.cells].wanted += wall.numberOfFaces >= preferences.minimumFaces || wall.cells != last ? 1 : 0;
    last = wall.cells;
  }
  for (const CornerPlace & corner : places.corners)
  {
    ++m_Corners[corner.cells].wanted;
  }
  for (const GeneralComplex::Edge & edge : complex.FindEdges())
  {
    ++m_Walls[edge.vertices].present;
  }
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    if (complex.IsAlive(id))
    {
      ++m_Corners[Ascending(complex.GetTetrahedron(id).vertices)].present;
    }
  }
}

double
PlaceEnergy::Difference(const GeneralComplex & complex, const GeneralMove & move) const
{
  return m_WallWeight * DifferenceOf(m_Walls, ChangesOfWalls(move)) +
         DifferenceOf(m_Corners, ChangesOfCorners(complex, move));
}

void
PlaceEnergy::Account(const GeneralComplex & complex, const GeneralMove & move)
{
  const Changes<VertexPair>      ofWalls = ChangesOfWalls(move);
  const Changes<VertexQuadruple> ofCorners = ChangesOfCorners(complex, move);
  for (const auto & [edge, change] : ofWalls.Get())
  {
    m_Walls[edge].present += change;
  }
  for (const auto & [tetrahedron, change] : ofCorners.Get())
  {
    m_Corners[tetrahedron].present += change;
  }
}

double
PlaceEnergy::Total() const
{
  return m_WallWeight * TotalOf(m_Walls) + TotalOf(m_Corners);
}

double
PlaceEnergy::CostOfEdge(VertexId u, VertexId v) const
{
  const auto entry = m_Walls.Get({ { std::min(u, v), std::max(u, v) } });
  return entry.present < entry.wanted ? -m_WallWeight : m_WallWeight;
}

double
PlaceEnergy::CostOfTetrahedron(const VertexQuadruple & vertices) const
{
  const auto entry = m_Corners.Get(Ascending(vertices));
  return entry.present < entry.wanted ? -1.0 : 1.0;
}

double
PlaceEnergy::CostWithoutEdge(VertexId u, VertexId v) const
{
  const auto entry = m_Walls.Get({ { std::min(u, v), std::max(u, v) } });
  return entry.present > entry.wanted ? -m_WallWeight : m_WallWeight;
}

double
PlaceEnergy::CostWithoutTetrahedron(const VertexQuadruple & vertices) const
{
  const auto entry = m_Corners.Get(Ascending(vertices));
  return entry.present > entry.wanted ? -1.0 : 1.0;
}
} // namespace tissue
