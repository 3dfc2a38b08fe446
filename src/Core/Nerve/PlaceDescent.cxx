/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/PlaceDescent.h"

#include "Nerve/GeneralMoves.h"

#include <limits>

namespace tissue
{
namespace
{
/** A move must lower the energy by more than this, in corners. Differences are sums of weights near 1, so that what is
 * smaller comes from rounding alone. */
constexpr double NoDifference = -1e-9;
/** One tetrahedron more, or less, lowers the energy by no more than this. */
constexpr double LargestGain = 1.0;

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
      if (this->TryToSwap({ id, i }))
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
    // An edge is seen by all tetrahedra around it; the last of them that is marked visits it. Mostly one of the two
    // that come next is marked.
    const auto & neighbors = m_Complex.GetTetrahedron(edge.tetrahedron).neighbors;
    for (int k = 0; k < 4; ++k)
    {
      if (k != edge.from && k != edge.to && m_IsMarked[neighbors[k]])
      {
        return false;
      }
    }
    const EdgeRing ring = m_Complex.GetRing(edge);
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
    return this->TryToRemove(edge, ring) || this->TryToSplit(ring);
  }

  bool
  TryToSwap(const Side & triangle)
  {
    const VertexQuadruple & t = m_Complex.GetTetrahedron(triangle.tetrahedron).vertices;
    const VertexId          a = t[triangle.opposite];
    const VertexId          b = m_Complex.VertexOpposite(m_Complex.GetMate(triangle));
    VertexQuadruple         other = t;
    other[triangle.opposite] = b;
    double cost =
      m_Energy.CostOfEdge(a, b) + m_Energy.CostWithoutTetrahedron(t) + m_Energy.CostWithoutTetrahedron(other);
    if (cost - 3.0 * LargestGain >= NoDifference)
    {
      return false;
    }
    for (int i = 0; i < 4; ++i)
    {
      if (i != triangle.opposite)
      {
        VertexQuadruple created = t;
        created[i] = b;
        cost += m_Energy.CostOfTetrahedron(created);
      }
    }
    return cost < NoDifference && this->TryToApply(SwapTriangle(m_Complex, triangle));
  }

  bool
  TryToRemove(const LocalEdge & edge, const EdgeRing & ring)
  {
    const VertexPair ends = this->EndsOf(ring);
    double           cost = m_Energy.CostWithoutEdge(ends[0], ends[1]);
    for (const RingStep & step : ring)
    {
      cost += m_Energy.CostWithoutTetrahedron(m_Complex.GetTetrahedron(step.tetrahedron).vertices);
    }
    // At the best all diagonals and all tetrahedra over the ring are wanted.
    const auto n = static_cast<double>(ring.size());
    if (cost - (n - 3.0) * m_Energy.GetWallWeight() - 2.0 * (n - 2.0) * LargestGain >= NoDifference)
    {
      return false;
    }
    const RingTriangulation triangles = this->BestTriangulation(ring);
    const auto              vertices = m_Complex.GetRingVertices(ring);
    for (const auto & [i, j, k] : triangles)
    {
      cost += this->CostOfTriangle(ends, vertices, i, j, k);
    }
    return !triangles.empty() && cost < NoDifference && this->TryToApply(RemoveEdge(m_Complex, edge, triangles));
  }

  VertexPair
  EndsOf(const EdgeRing & ring) const
  {
    const VertexQuadruple & t = m_Complex.GetTetrahedron(ring[0].tetrahedron).vertices;
    return { { t[ring[0].from], t[ring[0].to] } };
  }

  /** What the two tetrahedra over a triangle of a ring cost, with the diagonal that is its longest side. */
  double
  CostOfTriangle(VertexPair ends, const boost::container::small_vector<VertexId, 12> & ring, int i, int j, int k) const
  {
    const bool isDiagonal = k - i < static_cast<int>(ring.size()) - 1;
    return (isDiagonal ? m_Energy.CostOfEdge(ring[i], ring[k]) : 0.0) + this->CostOfTetrahedra(ends, ring, i, j, k);
  }

  double
  CostOfTetrahedra(VertexPair ends, const boost::container::small_vector<VertexId, 12> & ring, int i, int j,
                   int k) const
  {
    return m_Energy.CostOfTetrahedron({ { ends[0], ring[i], ring[j], ring[k] } }) +
           m_Energy.CostOfTetrahedron({ { ends[1], ring[i], ring[j], ring[k] } });
  }

  /** The triangulation of a ring that makes the least energy, as far as the parts are independent: a tetrahedron or an
   * edge that it makes twice is judged as if each were the first. */
  RingTriangulation
  BestTriangulation(const EdgeRing & ring) const
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const auto       vertices = m_Complex.GetRingVertices(ring);
    const VertexPair ends = this->EndsOf(ring);
    const int        n = static_cast<int>(vertices.size());
    // Of the triangles over a diagonal, and of the sides of the ring.
    std::vector<double> ofDiagonal(static_cast<std::size_t>(n) * n, 0.0);
    for (int i = 0; i < n; ++i)
    {
      for (int k = i + 2; k < n && k - i < n - 1; ++k)
      {
        // Costs must not be negative; as every triangulation has as many triangles and diagonals, they may be shifted.
        ofDiagonal[i * n + k] = m_Energy.GetWallWeight() + m_Energy.CostOfEdge(vertices[i], vertices[k]);
      }
    }
    const auto cost = [&](int i, int j, int k) {
      const VertexId a = vertices[i];
      const VertexId b = vertices[j];
      const VertexId c = vertices[k];
      return a == b || b == c || a == c ? infinite
                                        : 2.0 + ofDiagonal[i * n + k] + this->CostOfTetrahedra(ends, vertices, i, j, k);
    };
    return LeastCostTriangulation(n, cost);
  }

  /** The best split of an edge, if it lowers the energy. */
  bool
  TryToSplit(const EdgeRing & ring)
  {
    const VertexPair           ends = this->EndsOf(ring);
    const auto                 vertices = m_Complex.GetRingVertices(ring);
    const double               ofEdge = m_Energy.CostOfEdge(ends[0], ends[1]);
    double                     least = NoDifference;
    std::array<std::size_t, 2> best{ { 0, 0 } };
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      for (std::size_t j = i + 1; j < ring.size(); ++j)
      {
        if (vertices[i] == vertices[j])
        {
          continue;
        }
        const double ofEdges = ofEdge + m_Energy.CostOfEdge(vertices[i], vertices[j]);
        if (ofEdges - 2.0 * LargestGain >= NoDifference ||
            ofEdges + 2.0 * m_Energy.CostOfTetrahedron({ { ends[0], ends[1], vertices[i], vertices[j] } }) >=
              NoDifference)
        {
          continue;
        }
        const double difference = m_Energy.Difference(m_Complex, SplitEdge(m_Complex, ring, i, j).move);
        if (difference < least)
        {
          least = difference;
          best = { { i, j } };
        }
      }
    }
    return least < NoDifference && this->TryToApply(SplitEdge(m_Complex, ring, best[0], best[1]));
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
  return Descend(complex, places, preferences, {}, execution);
}

PlaceDescentResult
Descend(GeneralComplex & complex, const TissuePlaces & places, const PlacePreferences & preferences,
        const std::vector<JunctionVote> & votes, const Execution & execution)
{
  PlaceEnergy        energy(places, preferences, complex, votes);
  PlaceDescentResult result;
  result.energyBefore = energy.Total();
  Descent descent(complex, energy);
  // A move may make another one, far away, worth while: by the number of the same cells' walls and corners. In tissue
  // the second sweep finds few, if any; noise would go on for many sweeps for the sake of next to nothing.
  std::int64_t moves = 0;
  do
  {
    moves = descent.Sweep();
    result.numberOfMoves += moves;
    execution.Report(0.5);
  } while (moves > static_cast<std::int64_t>(complex.NumberOfTetrahedra() / 100));
  execution.Report(1.0);
  result.energyAfter = energy.Total();
  return result;
}
} // namespace tissue
