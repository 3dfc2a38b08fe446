/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TriangleBox_h
#define TissueTessellationCore_TriangleBox_h

#include "TissueTessellationCore/Geometry/BoxGrid.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
inline Box
BoxOfTriangle(const std::vector<Point> & points, const std::array<PointId, 3> & triangle)
{
  Box box{ points[triangle[0]], points[triangle[0]] };
  Extend(box, points[triangle[1]]);
  Extend(box, points[triangle[2]]);
  return box;
}
} // namespace tissue

#endif
