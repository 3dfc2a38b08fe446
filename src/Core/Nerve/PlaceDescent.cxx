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
#include <numeric>
#include <utility>

namespace tissue
{
namespace
{
/** A move must lower the energy by more than this, in corners. Differences are sums of weights near 1, so that what is
 * smaller comes from rounding alone. */
constexpr double NoDifference = -1e-9;
/** One tetrahedron more, or less, lowers the energy by no more than this. */
constexpr double LargestGain = 1.0;
/** A move that costs less than this costs nothing. With one that lowers the energy it still lowers it. */
constexpr double LeastCost = 5e-10;

/** Which single moves a visit carries out. */
enum class Admission
{
  /** Those that lower the energy. */
  Lowering,
  /** Also those that cost nothing, where one beside them lowers the energy then: both are carried out. */
  Opening
};

using RingVertices = boost::container::small_vector<VertexId, 12>;

class Descent
{
public:
  Descent(GeneralComplex & complex, PlaceEnergy & energy)
    : m_Complex(complex)
    , m_Energy(energy)
    , m_CountsOf(static_cast<std::size_t>(complex.TetrahedronIdBound()), -1)
  {
    for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
    {
      if (complex.IsAlive(id))
      {
        this->FindCountsOf(id);
      }
    }
  }

  /** Visits all tetrahedra, then all that were touched, until none is left. Returns the number of tetrahedra at which
   * it found a move, or two. */
  std::int64_t
  Sweep(Admission admission)
  {
    m_Limit = admission == Admission::Lowering ? NoDifference : LeastCost;
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
          moves += this->Visit(id) ? 1 : 0;
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

  /** Carries out one move at a tetrahedron, if there is one. */
  bool
  Visit(TetrahedronId id)
  {
    // An edge is seen by all tetrahedra around it; the last of them that is marked visits it.
    const auto & neighbors = m_Complex.GetTetrahedron(id).neighbors;
    return this->TryAtTetrahedron(
      id,
      [&](int i, int j) {
        const std::array<int, 2> others = EvenComplement(i, j);
        return !m_IsMarked[neighbors[others[0]]] && !m_IsMarked[neighbors[others[1]]];
      },
      [&](const EdgeRing & ring) {
        return std::none_of(
          ring.begin(), ring.end(), [&](const RingStep & step) { return m_IsMarked[step.tetrahedron]; });
      });
  }

  /** Tries the moves of the triangles of a tetrahedron, and those of the edges that may be asked for, by their local
   * vertices, if their rings are. */
  template <typename TMayBeAskedFor, typename TIsAskedFor>
  bool
  TryAtTetrahedron(TetrahedronId id, const TMayBeAskedFor & mayBeAskedFor, const TIsAskedFor & isAskedFor)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (this->TryToSwap({ id, i }))
      {
        return true;
      }
    }
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        if (!mayBeAskedFor(i, j))
        {
          continue;
        }
        const EdgeRing ring = m_Complex.GetRing({ id, i, j });
        if (isAskedFor(ring) && this->TryAtEdge({ id, i, j }, ring))
        {
          return true;
        }
      }
    }
    return false;
  }

  bool
  TryAtEdge(const LocalEdge & edge, const EdgeRing & ring)
  {
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
    const Side              mate = m_Complex.GetMate(triangle);
    const VertexId          b = m_Complex.VertexOpposite(mate);
    double                  cost =
      m_Energy.CostOfEdge(a, b) + this->CostWithout(triangle.tetrahedron) + this->CostWithout(mate.tetrahedron);
    if (cost - 3.0 * LargestGain >= m_Limit)
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
    return cost < m_Limit && this->TryToApply(SwapTriangle(m_Complex, triangle));
  }

  bool
  TryToRemove(const LocalEdge & edge, const EdgeRing & ring)
  {
    const VertexPair ends = this->EndsOf(ring);
    double           cost = m_Energy.CostWithoutEdge(ends[0], ends[1]);
    for (const RingStep & step : ring)
    {
      cost += this->CostWithout(step.tetrahedron);
    }
    // At the best all tetrahedra over the ring are wanted, and a wanted one gains 1; likewise its diagonals.
    const auto n = static_cast<double>(ring.size());
    if (cost - (n - 3.0) * m_Energy.GetWallWeight() - 2.0 * (n - 2.0) * LargestGain >= m_Limit)
    {
      return false;
    }
    const auto          vertices = m_Complex.GetRingVertices(ring);
    const DiagonalCosts ofDiagonal = this->CostsOfDiagonals(vertices);
    if (cost + LeastOfDiagonals(ofDiagonal, ring.size()) - 2.0 * (n - 2.0) * LargestGain >= m_Limit)
    {
      return false;
    }
    const RingTriangulation triangles = this->BestTriangulation(ends, vertices, ofDiagonal);
    for (const auto & [i, j, k] : triangles)
    {
      cost += this->CostOfTriangle(ends, vertices, i, j, k);
    }
    return !triangles.empty() && cost < m_Limit && this->TryToApply(RemoveEdge(m_Complex, edge, triangles));
  }

  VertexPair
  EndsOf(const EdgeRing & ring) const
  {
    const VertexQuadruple & t = m_Complex.GetTetrahedron(ring[0].tetrahedron).vertices;
    return { { t[ring[0].from], t[ring[0].to] } };
  }

  /** What the two tetrahedra over a triangle of a ring cost, with the diagonal that is its longest side. */
  double
  CostOfTriangle(VertexPair ends, const RingVertices & ring, int i, int j, int k) const
  {
    const bool isDiagonal = k - i < static_cast<int>(ring.size()) - 1;
    return (isDiagonal ? m_Energy.CostOfEdge(ring[i], ring[k]) : 0.0) + this->CostOfTetrahedra(ends, ring, i, j, k);
  }

  double
  CostOfTetrahedra(VertexPair ends, const RingVertices & ring, int i, int j, int k) const
  {
    return m_Energy.CostOfTetrahedron({ { ends[0], ring[i], ring[j], ring[k] } }) +
           m_Energy.CostOfTetrahedron({ { ends[1], ring[i], ring[j], ring[k] } });
  }

  /** Whether two vertices of a ring, i < k, are no neighbours in it. */
  static bool
  IsDiagonal(int n, int i, int k)
  {
    return k - i > 1 && k - i < n - 1;
  }

  /** Of all pairs of vertices of a ring, row by row, what an edge more between them costs; of its sides nothing. */
  using DiagonalCosts = boost::container::small_vector<double, 64>;

  DiagonalCosts
  CostsOfDiagonals(const RingVertices & ring) const
  {
    const int     n = static_cast<int>(ring.size());
    DiagonalCosts costs(ring.size() * ring.size(), 0.0);
    for (int i = 0; i < n; ++i)
    {
      for (int k = i + 2; k < n; ++k)
      {
        costs[i * n + k] = IsDiagonal(n, i, k) ? m_Energy.CostOfEdge(ring[i], ring[k]) : 0.0;
      }
    }
    return costs;
  }

  /** What the diagonals of a triangulation of a ring cost at least: that of those of the least costs. */
  static double
  LeastOfDiagonals(const DiagonalCosts & ofDiagonal, std::size_t size)
  {
    const int     n = static_cast<int>(size);
    DiagonalCosts costs;
    for (int i = 0; i < n; ++i)
    {
      for (int k = i + 2; k < n; ++k)
      {
        if (IsDiagonal(n, i, k))
        {
          costs.push_back(ofDiagonal[i * n + k]);
        }
      }
    }
    const auto end = costs.begin() + (n - 3);
    std::partial_sort(costs.begin(), end, costs.end());
    return std::accumulate(costs.begin(), end, 0.0);
  }

  /** The triangulation of a ring that makes the least energy, as far as the parts are independent: a tetrahedron or an
   * edge that it makes twice is judged as if each were the first. */
  RingTriangulation
  BestTriangulation(const VertexPair & ends, const RingVertices & vertices, const DiagonalCosts & ofDiagonal) const
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const int        n = static_cast<int>(vertices.size());
    const auto       cost = [&](int i, int j, int k) {
      const VertexId a = vertices[i];
      const VertexId b = vertices[j];
      const VertexId c = vertices[k];
      // Costs must not be negative; as every triangulation has as many triangles and diagonals, they may be shifted.
      const double shift = 2.0 * LargestGain + (IsDiagonal(n, i, k) ? m_Energy.GetWallWeight() : 0.0);
      return a == b || b == c || a == c
                     ? infinite
                     : shift + ofDiagonal[i * n + k] + this->CostOfTetrahedra(ends, vertices, i, j, k);
    };
    return LeastCostTriangulation(n, cost);
  }

  /** The splits of an edge that are worth it, the best first. */
  bool
  TryToSplit(const EdgeRing & ring)
  {
    struct Split
    {
      std::size_t i;
      std::size_t j;
      double      difference;
    };
    const VertexPair         ends = this->EndsOf(ring);
    const auto               vertices = m_Complex.GetRingVertices(ring);
    const double             ofEdge = m_Energy.CostOfEdge(ends[0], ends[1]);
    GeneralMove::List<Split> splits;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      for (std::size_t j = i + 1; j < ring.size(); ++j)
      {
        if (vertices[i] == vertices[j])
        {
          continue;
        }
        const double ofEdges = ofEdge + m_Energy.CostOfEdge(vertices[i], vertices[j]);
        if (ofEdges - 2.0 * LargestGain >= m_Limit ||
            ofEdges + 2.0 * m_Energy.CostOfTetrahedron({ { ends[0], ends[1], vertices[i], vertices[j] } }) >= m_Limit)
        {
          continue;
        }
        splits.push_back({ i, j, m_Energy.Difference(m_Complex, SplitEdge(m_Complex, ring, i, j).move) });
      }
    }
    std::stable_sort(
      splits.begin(), splits.end(), [](const Split & a, const Split & b) { return a.difference < b.difference; });
    return std::any_of(splits.begin(), splits.end(), [&](const Split & split) {
      return split.difference < m_Limit && this->TryToApply(SplitEdge(m_Complex, ring, split.i, split.j));
    });
  }

  bool
  TryToApply(const MoveProposal & proposal)
  {
    const double difference = proposal ? m_Energy.Difference(m_Complex, proposal.move) : m_Limit;
    if (difference >= m_Limit)
    {
      return false;
    }
    const GeneralMove inverse = this->Apply(proposal.move);
    const auto        touched = this->FindTouched(inverse);
    if (difference >= NoDifference && !this->TryToLower(touched))
    {
      this->Apply(inverse);
      return false;
    }
    for (const TetrahedronId id : touched)
    {
      this->MarkWithNeighbors(id);
    }
    return true;
  }

  /** Tries all that lowers the energy at some tetrahedra. */
  bool
  TryToLower(const std::vector<TetrahedronId> & tetrahedra)
  {
    const double limit = std::exchange(m_Limit, NoDifference);
    const bool   isLowered = std::any_of(tetrahedra.begin(), tetrahedra.end(), [&](TetrahedronId id) {
      return this->TryAtTetrahedron(
        id, [](int, int) { return true; }, [](const EdgeRing &) { return true; });
    });
    m_Limit = limit;
    return isLowered;
  }

  /** Returns the inverse. */
  GeneralMove
  Apply(const GeneralMove & move)
  {
    m_Energy.Account(m_Complex, move);
    GeneralMove inverse = m_Complex.Apply(move);
    m_CountsOf.resize(static_cast<std::size_t>(m_Complex.TetrahedronIdBound()), -1);
    for (const TetrahedronId id : inverse.removed)
    {
      this->FindCountsOf(id);
    }
    return inverse;
  }

  void
  FindCountsOf(TetrahedronId id)
  {
    m_CountsOf[id] = m_Energy.IndexOfTetrahedron(m_Complex.GetTetrahedron(id).vertices);
  }

  double
  CostWithout(TetrahedronId id) const
  {
    return m_Energy.CostWithoutTetrahedron(m_CountsOf[id]);
  }

  /** What a move has made, and what it has glued to that. */
  static std::vector<TetrahedronId>
  FindTouched(const GeneralMove & inverse)
  {
    std::vector<TetrahedronId> touched(inverse.removed.begin(), inverse.removed.end());
    for (const GeneralMove::Gluing & gluing : inverse.gluings)
    {
      for (const Side & side : { gluing.a, gluing.b })
      {
        const bool isKnown = std::find(touched.begin(), touched.end(), side.tetrahedron) != touched.end();
        if (!GeneralMove::IsCreated(side.tetrahedron) && !isKnown)
        {
          touched.push_back(side.tetrahedron);
        }
      }
    }
    return touched;
  }

  /** Of a tetrahedron that a second move has removed nothing is left to mark. */
  void
  MarkWithNeighbors(TetrahedronId id)
  {
    if (!m_Complex.IsAlive(id))
    {
      return;
    }
    this->Mark(id);
    for (const TetrahedronId neighbor : m_Complex.GetTetrahedron(id).neighbors)
    {
      this->Mark(neighbor);
    }
  }

  GeneralComplex & m_Complex;
  PlaceEnergy &    m_Energy;
  /** Of each tetrahedron where the energy has its counts: asked for time and again. */
  std::vector<std::int32_t> m_CountsOf;
  /** What the difference of a move must be less than. */
  double                     m_Limit = NoDifference;
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
    moves = descent.Sweep(Admission::Lowering);
    result.numberOfMoves += moves;
    execution.Report(0.5);
  } while (moves > static_cast<std::int64_t>(complex.NumberOfTetrahedra() / 100));
  result.numberOfMoves += descent.Sweep(Admission::Opening);
  execution.Report(1.0);
  result.energyAfter = energy.Total();
  return result;
}
} // namespace tissue
