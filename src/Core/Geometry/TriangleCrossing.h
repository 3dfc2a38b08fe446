/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TriangleCrossing_h
#define TissueTessellationCore_TriangleCrossing_h

#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
/** \brief Whether two triangles have a point in common that is not on the points and edges that they share.
 *
 * The edges and corners of a triangle belong to it, and triangles share points that have the same index. A mesh is
 * embedded exactly if no two of its triangles cross. So
 * - two without a shared point cross where they touch, be it at equal points of different indices;
 * - two that share a point cross where the edge of one that is opposite to it meets the other;
 * - two that share an edge cross where one is folded by 180 degrees onto the other;
 * - two that share all three points are the same, and cross.
 *
 * The answer is exact for every finite input. A triangle whose points are on one line is the segment that it covers;
 * two such triangles that share an edge do not cross. */
bool
TrianglesCross(const std::vector<Point> & points, const Triangle & a, const Triangle & b);
} // namespace tissue

#endif
