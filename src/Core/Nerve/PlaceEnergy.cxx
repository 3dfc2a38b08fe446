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

} // namespace

PlaceEnergy::PlaceEnergy(const TissuePlaces & places, const PlacePreferences & preferences,
                         const GeneralComplex & complex, const std::vector<JunctionVote> & votes)
  : m_WallWeight(preferences.wallWeight)
  , m_LeastVote(preferences.leastVote)
  , m_RepeatedCorner(preferences.repeatedCorner)
  , m_HasVotes(!votes.empty())
{
  // What is there comes first, in the order of the complex, which is one in space: so do the counts that a move needs.
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
  for (const JunctionVote & vote : votes)
  {
    m_Corners[vote.cells].share = static_cast<float>(vote.share);
  }
}

double
PlaceEnergy::Difference(const GeneralComplex & complex, const GeneralMove & move) const
{
  const Changes<VertexPair>      ofWalls = ChangesOfWalls(move);
  const Changes<VertexQuadruple> ofCorners = ChangesOfCorners(complex, move);
  double                         difference = 0.0;
  for (const auto & [edge, change] : ofWalls.Get())
  {
    difference += this->ChangeOfEnergy(m_Walls.Get(edge), change);
  }
  for (const auto & [tetrahedron, change] : ofCorners.Get())
  {
    difference += this->ChangeOfEnergy(m_Corners.Get(tetrahedron), change);
  }
  return difference;
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
  double total = 0.0;
  for (const auto & wall : m_Walls.GetEntries())
  {
    total += this->EnergyOf(wall, wall.present);
  }
  for (const auto & corner : m_Corners.GetEntries())
  {
    total += this->EnergyOf(corner, corner.present);
  }
  return total;
}

double
PlaceEnergy::CostOfEdge(VertexId u, VertexId v) const
{
  return this->ChangeOfEnergy(m_Walls.Get({ { std::min(u, v), std::max(u, v) } }), 1);
}

double
PlaceEnergy::CostOfTetrahedron(const VertexQuadruple & vertices) const
{
  return this->ChangeOfEnergy(m_Corners.Get(Ascending(vertices)), 1);
}

double
PlaceEnergy::CostWithoutEdge(VertexId u, VertexId v) const
{
  return this->ChangeOfEnergy(m_Walls.Get({ { std::min(u, v), std::max(u, v) } }), -1);
}

double
PlaceEnergy::CostWithoutTetrahedron(const VertexQuadruple & vertices) const
{
  return this->ChangeOfEnergy(m_Corners.Get(Ascending(vertices)), -1);
}

std::int32_t
PlaceEnergy::IndexOfTetrahedron(const VertexQuadruple & vertices) const
{
  return m_Corners.IndexOf(Ascending(vertices));
}
} // namespace tissue
