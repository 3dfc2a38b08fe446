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
class ReferenceAdjacency;

struct SurfaceCleanUpParameters
{
  /** l_max: a surface triangle with a longer edge is oversized. In the units of the centres; must be above 0. */
  double maximumEdgeLength = 0.0;
  /** Of each vertex, the length that maximumEdgeLength is a multiple of, for an edge the mean of its two ends': a limit
   * that follows the local spacing (LocalSpacing.h). Empty: all are 1. */
  std::vector<double> localLengths;
  /** With a reference: only edges that are no pair of it count as oversized, and no cell that does not touch the
   * exterior in the reference is exposed. */
  bool guidedByReference = false;
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
CleanSurface(AdjacencyComplex & complex, const std::vector<Point> & centers, const ReferenceAdjacency * reference,
             const SurfaceCleanUpParameters & parameters);

} // namespace tissue

#endif
