/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TriangleCrossing_h
#define TissueTessellationCore_TriangleCrossing_h

#include "TissueTessellationCore/WallMesh.h"

namespace tissue
{
/** Whether two triangles have a point in common other than their shared points. Exact but for triangles in one plane;
 * false for two that share an edge. */
bool
TrianglesCross(const std::vector<Point> & points, const std::array<PointId, 3> & a, const std::array<PointId, 3> & b);
} // namespace tissue

#endif
