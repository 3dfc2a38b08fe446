/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SurfaceCleanUp_h
#define TissueTessellationCore_SurfaceCleanUp_h

#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
class AdjacencyComplex;

struct SurfaceCleanUpParameters
{
  /** The paper's l_max: a surface triangle with a longer edge is oversized. It is in the units of the centres, or, with
   * localLengths, a multiple of them, and must be above 0. */
  double maximumEdgeLength = 0.0;
  /** A length for each vertex, so that the limit follows the local spacing (LocalSpacing.h): the limit of an edge is
   * maximumEdgeLength times the mean of its two ends' lengths. If empty, all lengths are 1. */
  std::vector<double> localLengths;
};

struct SurfaceCleanUpResult
{
  std::size_t numberOfSwaps = 0;
  std::size_t numberOfRemovals = 0;
};

/** \brief Removes the oversized triangles that the convex Delaunay tetrahedralization spans over the concave parts of a
 * tissue (paper, section 3.3), in passes until none can go.
 *
 * An oversized surface triangle is swapped, which makes the vertex behind it a neighbour of the exterior. Where that
 * vertex is on the surface already, an oversized edge of the triangle is removed instead if three tetrahedra are
 * incident to it. Both are combinatorially legal operations that take one tetrahedron from the tissue, so the passes
 * end. */
SurfaceCleanUpResult
CleanSurface(AdjacencyComplex & complex, const std::vector<Point> & centers,
             const SurfaceCleanUpParameters & parameters);

} // namespace tissue

#endif
