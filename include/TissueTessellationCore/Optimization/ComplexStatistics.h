/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ComplexStatistics_h
#define TissueTessellationCore_ComplexStatistics_h

#include "TissueTessellationCore/Common/Types.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "TissueTessellationCore/Optimization/OptimizationParameters.h"

#include <vector>

namespace tissue
{
class ReferenceAdjacency;

/** \brief The columns of the paper's Tables 1 and 2 (section 4.1), and counts, of one stage of the complex. */
struct ComplexStatistics
{
  /** With the reference; empty where there is none. */
  AdjacencyOverlap overlap;
  /** The mean over the cells of ((n - N) / N)^2: the deviation of equation 3, relative to the ideal number N of
   * neighbours. */
  double neighborhoodError = 0.0;
  /** The mean over the tetrahedra of cells of 1 - 216 sqrt(3) V^2 / A^3, where V is the volume and A the surface area:
   * 0 for a regular tetrahedron, 1 for a flat one. */
  double eccentricity = 0.0;
  /** The means over the tetrahedra of cells of the smallest and of the largest dihedral angle, in degrees. */
  double minimalDihedralAngle = 0.0;
  double maximalDihedralAngle = 0.0;

  /** The numbers of all tetrahedra and of all pairs of neighbours, those with the exterior included. */
  std::size_t numberOfTetrahedra = 0;
  std::size_t numberOfEdges = 0;
  /** The number of tetrahedra of four cells, without the exterior. */
  std::size_t numberOfInnerTetrahedra = 0;
  /** The number of tetrahedra of four cells that are flat or inverted, with the cell centres as positions. */
  std::size_t numberOfInvertedTetrahedra = 0;
  /** The number of cells that touch the exterior in the complex. */
  std::size_t numberOfEpidermalCells = 0;
};

/** Computes the statistics of a complex by its tetrahedra, positively oriented and each with the exterior first where
 * it has it, and its tuples. `reference` may be null. The ideal numbers of neighbours are those of the parameters. */
ComplexStatistics
ComputeStatistics(const std::vector<VertexQuadruple> & tetrahedra, const AdjacencyTuples & tuples,
                  const std::vector<Point> & centers, const ReferenceAdjacency * reference,
                  const EnergyParameters & parameters);
} // namespace tissue

#endif
