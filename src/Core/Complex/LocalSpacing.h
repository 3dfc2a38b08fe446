/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LocalSpacing_h
#define TissueTessellationCore_LocalSpacing_h

#include "Complex/AdjacencyComplex.h"

#include <vector>

namespace tissue
{
/** \brief Returns how far apart points are around each of them: the mean distance to its eight nearest others, or to
 * all where there are fewer.
 *
 * \param complex the points' Delaunay tetrahedralization with the exterior, as DelaunayTetrahedralization() makes it.
 * In another complex of the same points, the nearest ones are those that a walk along its edges meets.
 * \param centers the positions of its vertices; the exterior's is ignored.
 * \return one distance for each vertex, which is 0 for the exterior. */
std::vector<double>
LocalSpacings(const AdjacencyComplex & complex, const std::vector<Point> & centers);

/** Returns the local spacings of points alone, in any arrangement, which are the vertices after the exterior. */
std::vector<double>
LocalSpacings(const std::vector<Point> & points);

/** Returns the median of the spacings that LocalSpacings() returns, without the exterior's; of an even number the upper
 * one. There must be at least one other vertex. */
double
MedianSpacing(const std::vector<double> & spacings);
} // namespace tissue

#endif
