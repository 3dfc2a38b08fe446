/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Image/PlaceTree.h"

namespace tissue
{
AreaAndDistance
IntegrateDistance(const WallMesh & mesh, std::size_t firstTriangle, std::size_t endTriangle, const PlaceTree & places)
{
  AreaAndDistance sums;
  for (std::size_t t = firstTriangle; t < endTriangle; ++t)
  {
    const Point & a = mesh.points[mesh.triangles[t][0]];
    const Point & b = mesh.points[mesh.triangles[t][1]];
    const Point & c = mesh.points[mesh.triangles[t][2]];
    const double  area = TriangleArea(a, b, c);
    sums.area += area;
    sums.distance += area * places.DistanceToNearest((1.0 / 3.0) * (a + b + c));
  }
  return sums;
}
} // namespace tissue
