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
/** \brief How far apart points are about each of them: the mean distance of its eight nearest others, or of all where
 * there are fewer.
 *
 * \param complex their Delaunay tetrahedralization with the exterior, as DelaunayTetrahedralization() makes it. Of
 * another one of the same points, these are the nearest that a walk along its edges meets.
 * \param centers positions of its vertices; the exterior's is ignored.
 * \return a distance a vertex, of the exterior 0. */
std::vector<double>
LocalSpacings(const AdjacencyComplex & complex, const std::vector<Point> & centers);

/** The same of points alone, as the vertices after the exterior. No two are equal. */
std::vector<double>
LocalSpacings(const std::vector<Point> & points);

/** Of spacings of vertices, as LocalSpacings() returns them, the median, the upper one of an even number: the
 * exterior's does not count. There must be another. */
double
MedianSpacing(const std::vector<double> & spacings);
} // namespace tissue

#endif
