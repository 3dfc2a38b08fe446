/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_EnergyFunction_h
#define TissueTessellationCore_EnergyFunction_h

#include "Adjacency/ReferenceAdjacency.h"
#include "Complex/AdjacencyComplex.h"
#include "Optimization/DelaunayDeviation.h"
#include "TissueTessellationCore/Optimization/OptimizationParameters.h"

#include <optional>
#include <vector>

namespace tissue
{

/** \brief The energy of a complex (paper, equations 1 to 4), kept up to date with it.
 *
 * E = - w_adjacency |T & S| / |T | S| - w_pair |E_T & E_S| / |E_T | E_S| + w_neighbor mean over cells of (n - N)^2
 *     + w_length mean over tetrahedra of the longest edge + w_Delaunay sum of deviations a cell,
 * where a cell's ideal number N is epidermalNeighbors + 1 where it touches the exterior, which is counted in n. A
 * tetrahedron with the exterior, which has no position, has the longest edge of its triangle of cells.
 *
 * Where the reference has votes, (sum over T of (share of the votes - leastVote)) / |S| is in the place of
 * |T & S| / |T | S|: what is sure counts for more than what is just likely.
 *
 * Difference() takes time in the size of the replacement alone. */
class EnergyFunction
{
public:
  /** All references must outlive this object; `reference` may be null. */
  EnergyFunction(const AdjacencyComplex & complex, const std::vector<Point> & centers,
                 const ReferenceAdjacency * reference, const EnergyParameters & parameters);

  /** Takes the complex as it is, after a change that Update() was not told of. Spacings stay those at the start. */
  void
  Recompute();

  /** The energy of the complex as this object knows it. */
  double
  Total() const
  {
    return Evaluate(m_Sums);
  }

  /** Total() after the replacement less Total() before it, without carrying it out. */
  double
  Difference(const Replacement & replacement) const
  {
    return Evaluate(SumsAfter(replacement)) - Total();
  }

  /** To be called before AdjacencyComplex::Apply() with the same replacement. */
  void
  Update(const Replacement & replacement)
  {
    m_Sums = SumsAfter(replacement);
  }

  const ReferenceAdjacency *
  GetReference() const
  {
    return m_Reference;
  }

  /** Tetrahedra that are in the reference. */
  std::int64_t
  NumberOfHits() const
  {
    return m_Sums.hits;
  }

private:
  struct Sums
  {
    std::int64_t hits = 0;
    std::int64_t tetrahedra = 0;
    std::int64_t pairHits = 0;
    std::int64_t edges = 0;
    double       prior = 0.0;
    double       length = 0.0;
    double       delaunayDeviation = 0.0;
    double       votes = 0.0;
  };

  double
  Evaluate(const Sums & sums) const;

  double
  QuadrupleTerm(const Sums & sums) const;

  Sums
  SumsAfter(const Replacement & replacement) const;

  void
  AddEdge(VertexPair edge, int sign, Sums & sums) const;

  void
  AddTetrahedron(const VertexQuadruple & vertices, int sign, Sums & sums) const;

  double
  LongestEdge(const VertexQuadruple & vertices) const;

  /** Squared deviation from the ideal number of neighbours. */
  double
  NeighborDeviation(std::int32_t numberOfNeighbors, bool touchesExterior) const;

  const AdjacencyComplex &   m_Complex;
  const std::vector<Point> & m_Centers;
  const ReferenceAdjacency * m_Reference;
  EnergyParameters           m_Parameters;
  /** Where it has a weight. */
  std::optional<DelaunayDeviation> m_DelaunayDeviation;
  Sums                             m_Sums;
};
} // namespace tissue

#endif
