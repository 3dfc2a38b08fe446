/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/PlaceDescent.h"

#include "Nerve/GeneralMoves.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace tissue
{
namespace
{
/** Energies are sums of the two weights: anything below half of the smaller one's last digit is no difference. */
constexpr double NoDifference = -1e-9;

class Descent
{
public:
  Descent(GeneralComplex & complex, PlaceEnergy & energy)
    : m_Complex(complex)
    , m_Energy(energy)
  {}

  /** Visits all tetrahedra, then all that were touched, until none is left. Returns the number of moves. */
  std::int64_t
  Sweep()
  {
    std::int64_t               moves = 0;
    std::vector<TetrahedronId> round;
    for (TetrahedronId id = 0; id < m_Complex.TetrahedronIdBound(); ++id)
    {
      this->Mark(id);
    }
    while (!m_Marked.empty())
    {
      round.swap(m_Marked);
      m_Marked.clear();
      for (const TetrahedronId id : round)
      {
        const bool isMarked = m_IsMarked[id];
        m_IsMarked[id] = false;
        if (isMarked && m_Complex.IsAlive(id))
        {
          moves += this->Visit(id);
        }
      }
    }
    return moves;
  }

private:
  void
  Mark(TetrahedronId id)
  {
    m_IsMarked.resize(static_cast<std::size_t>(m_Complex.TetrahedronIdBound()), false);
    if (!m_IsMarked[id] && m_Complex.IsAlive(id))
    {
      m_IsMarked[id] = true;
      m_Marked.push_back(id);
    }
  }

  /** Carries out the moves of a tetrahedron as long as it is there. */
  std::int64_t
  Visit(TetrahedronId id)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (this->TryToApply(SwapTriangle(m_Complex, { id, i })))
      {
        return 1;
      }
    }
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        if (this->VisitEdge({ id, i, j }))
        {
          return 1;
        }
      }
    }
    return 0;
  }

  bool
  VisitEdge(const LocalEdge & edge)
  {
    const EdgeRing ring = m_Complex.GetRing(edge);
    // An edge is seen by all tetrahedra around it; the last of them that is marked visits it.
    for (const RingStep & step : ring)
    {
      if (m_IsMarked[step.tetrahedron])
      {
        return false;
      }
    }
    if (ring.size() == 2)
    {
      return this->TryToApply(CloseEdge(m_Complex, edge));
    }
    return this->TryToApply(RemoveEdge(m_Complex, edge, this->BestTriangulation(ring))) || this->TryToSplit(ring);
  }

  /** The triangulation of a ring that makes the least energy, as far as the parts are independent: a tetrahedron or an
   * edge that it makes twice is judged as if each were the first. */
  RingTriangulation
  BestTriangulation(const EdgeRing & ring) const
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const auto       vertices = m_Complex.GetRingVertices(ring);
    const auto &     t = m_Complex.GetTetrahedron(ring[0].tetrahedron).vertices;
    const VertexId   u = t[ring[0].from];
    const VertexId   v = t[ring[0].to];
    const int        n = static_cast<int>(vertices.size());
    const auto       cost = [&](int i, int j, int k) {
      const VertexId a = vertices[i];
      const VertexId b = vertices[j];
      const VertexId c = vertices[k];
      if (a == b || b == c || a == c)
      {
        return infinite;
      }
      // Costs must not be negative; as every triangulation has as many triangles and diagonals, it may be shifted.
      const bool   isDiagonal = k - i < n - 1;
      const double ofDiagonal = isDiagonal ? m_Energy.GetWallWeight() + m_Energy.CostOfEdge(a, c) : 0.0;
      return ofDiagonal + 2.0 + m_Energy.CostOfTetrahedron({ { u, a, b, c } }) +
             m_Energy.CostOfTetrahedron({ { v, a, b, c } });
    };
    return LeastCostTriangulation(n, cost);
  }

  /** The best split of an edge, if it lowers the energy. */
  bool
  TryToSplit(const EdgeRing & ring)
  {
    const auto &                t = m_Complex.GetTetrahedron(ring[0].tetrahedron).vertices;
    const VertexPair            ends{ { t[ring[0].from], t[ring[0].to] } };
    const auto                  vertices = m_Complex.GetRingVertices(ring);
    const bool                  isEdgeMissing = m_Energy.CostOfEdge(ends[0], ends[1]) < 0.0;
    double                      least = NoDifference;
    std::optional<MoveProposal> best;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      for (std::size_t j = i + 1; j < ring.size(); ++j)
      {
        // Two walls and two corners of the same cells each: where none is missing the split cannot pay.
        if (vertices[i] == vertices[j] ||
            (!isEdgeMissing && m_Energy.CostOfEdge(vertices[i], vertices[j]) > 0.0 &&
             m_Energy.CostOfTetrahedron({ { ends[0], ends[1], vertices[i], vertices[j] } }) > 0.0))
        {
          continue;
        }
        MoveProposal proposal = SplitEdge(m_Complex, ring, i, j);
        const double difference = m_Energy.Difference(m_Complex, proposal.move);
        if (difference < least)
        {
          least = difference;
          best = std::move(proposal);
        }
      }
    }
    return best && this->TryToApply(*best);
  }

  bool
  TryToApply(const MoveProposal & proposal)
  {
    if (!proposal || m_Energy.Difference(m_Complex, proposal.move) >= NoDifference)
    {
      return false;
    }
    m_Energy.Account(m_Complex, proposal.move);
    const GeneralMove inverse = m_Complex.Apply(proposal.move);
    for (const TetrahedronId id : inverse.removed)
    {
      this->MarkWithNeighbors(id);
    }
    for (const GeneralMove::Gluing & gluing : inverse.gluings)
    {
      for (const Side & side : { gluing.a, gluing.b })
      {
        if (!GeneralMove::IsCreated(side.tetrahedron))
        {
          this->MarkWithNeighbors(side.tetrahedron);
        }
      }
    }
    return true;
  }

  void
  MarkWithNeighbors(TetrahedronId id)
  {
    this->Mark(id);
    for (const TetrahedronId neighbor : m_Complex.GetTetrahedron(id).neighbors)
    {
      this->Mark(neighbor);
    }
  }

  GeneralComplex &           m_Complex;
  PlaceEnergy &              m_Energy;
  std::vector<TetrahedronId> m_Marked;
  std::vector<bool>          m_IsMarked;
};
} // namespace

PlaceDescentResult
Descend(GeneralComplex & complex, const TissuePlaces & places, const PlacePreferences & preferences,
        const Execution & execution)
{
  PlaceEnergy        energy(places, preferences, complex);
  PlaceDescentResult result;
  result.energyBefore = energy.Total();
  Descent descent(complex, energy);
  // A move may make another one, far away, worth while: by the number of the same cells' walls and corners.
  for (std::int64_t moves = descent.Sweep(); moves > 0; moves = descent.Sweep())
  {
    result.numberOfMoves += moves;
    execution.Report(0.5);
  }
  execution.Report(1.0);
  result.energyAfter = energy.Total();
  return result;
}
} // namespace tissue
