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
 * E = - w_adjacency |T & S| / |T | S| + w_neighbor mean over cells of (n - N)^2
 *     + w_length mean over tetrahedra of the longest edge + w_Delaunay sum of deviations a cell,
 * where T are the tetrahedra of the complex, S the quadruples of the reference, and n is the number of a cell's
 * neighbours. Its ideal number N is innerNeighbors; for a cell that touches the exterior, which counts as a neighbour,
 * it is epidermalNeighbors + 1. The longest edge of a tetrahedron with the
 * exterior, which has no position, is that of its triangle of cells.
 *
 * All terms are functions of sums over the elements of the complex, which are kept. So Difference() takes a time that
 * grows with the size of the replacement alone. */
class EnergyFunction
{
public:
  /** All references must outlive this object. `reference` may be null. */
  EnergyFunction(const AdjacencyComplex & complex, const std::vector<Point> & centers,
                 const ReferenceAdjacency * reference, const EnergyParameters & parameters);

  /** Takes the complex as it is, after a change that Update() was not told of. Spacings stay those of the start. */
  void
  Recompute();

  /** Returns the energy of the complex as this object knows it. */
  double
  Total() const
  {
    return Evaluate(m_Sums);
  }

  /** Returns what Total() would be after the replacement, less what it is; the replacement is not carried out. */
  double
  Difference(const Replacement & replacement) const
  {
    return Evaluate(SumsAfter(replacement)) - Total();
  }

  /** Follows a replacement. It must be called before AdjacencyComplex::Apply() with the same one. */
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

private:
  /** The sums over the elements of the complex of which the energy is a function. */
  struct Sums
  {
    std::int64_t hits = 0;
    std::int64_t tetrahedra = 0;
    double       prior = 0.0;
    double       length = 0.0;
    double       delaunayDeviation = 0.0;
  };

  /** Returns the energy for some sums. */
  double
  Evaluate(const Sums & sums) const;

  /** Returns the sums after a replacement that has not been carried out yet. */
  Sums
  SumsAfter(const Replacement & replacement) const;

  /** Adds a tetrahedron to the sums with sign +1, and takes it away with sign -1. */
  void
  AddTetrahedron(const VertexQuadruple & vertices, int sign, Sums & sums) const;

  double
  LongestEdge(const VertexQuadruple & vertices) const;

  /** Returns the squared deviation from the ideal number of neighbours. */
  double
  NeighborDeviation(std::int32_t numberOfNeighbors, bool touchesExterior) const;

  const AdjacencyComplex &   m_Complex;
  const std::vector<Point> & m_Centers;
  const ReferenceAdjacency * m_Reference;
  EnergyParameters           m_Parameters;
  /** The deviation from Delaunay; it is there only if it has a weight. */
  std::optional<DelaunayDeviation> m_DelaunayDeviation;
  Sums                             m_Sums;
};
} // namespace tissue

#endif
