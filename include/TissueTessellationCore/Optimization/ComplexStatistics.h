/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ComplexStatistics_h
#define TissueTessellationCore_ComplexStatistics_h

#include "TissueTessellationCore/Common/Types.h"
#include "TissueTessellationCore/Optimization/OptimizationParameters.h"

#include <vector>

namespace tissue
{
class AdjacencyComplex;
class ReferenceAdjacency;

/** \brief The columns of the paper's Tables 1 and 2 (section 4.1), and counts, of one stage of the complex. */
struct ComplexStatistics
{
  /** Jaccard indices; 0 where there is no reference. */
  double adjacency2 = 0.0;
  double adjacency4 = 0.0;
  /** Mean over the cells of ((n - N) / N)^2: equation 3's deviation, relative to the ideal number N of neighbours. */
  double neighborhoodError = 0.0;
  /** Mean over the tetrahedra of cells of 1 - 216 sqrt(3) V^2 / A^3, V the volume and A the surface area: 0 for a
   * regular one, 1 for a flat one. */
  double eccentricity = 0.0;
  /** Means over the tetrahedra of cells of the smallest and the largest dihedral angle, in degrees. */
  double minimalDihedralAngle = 0.0;
  double maximalDihedralAngle = 0.0;

  /** Counts, elements at the exterior included. */
  std::size_t numberOfTetrahedra = 0;
  std::size_t numberOfEdges = 0;
  /** Tetrahedra of four cells, without the exterior. */
  std::size_t numberOfInnerTetrahedra = 0;
  /** Those of them that are flat or inverted with the cell centres as positions. */
  std::size_t numberOfInvertedTetrahedra = 0;
  /** Cells that touch the exterior in the complex. */
  std::size_t numberOfEpidermalCells = 0;
};

/** `reference` may be null. Ideal numbers of neighbours are those of the parameters. */
ComplexStatistics
ComputeStatistics(const AdjacencyComplex & complex, const std::vector<Point> & centers,
                  const ReferenceAdjacency * reference, const EnergyParameters & parameters);
} // namespace tissue

#endif
