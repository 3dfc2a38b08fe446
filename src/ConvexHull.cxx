/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/ConvexHull.h"

#include "TissueTessellationCore/Vector.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <numeric>

namespace tissue
{
double
ConvexHullVolume(const std::vector<Point> & points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  std::vector<Kernel::Point_3> input;
  for (const Point & p : points)
  {
    input.emplace_back(p[0], p[1], p[2]);
  }
  Mesh hull;
  CGAL::convex_hull_3(input.begin(), input.end(), hull);
  // The order of the faces, and where each begins, depend on addresses in memory: the sum must not.
  std::vector<double> sixfoldVolumes;
  for (const Mesh::Face_index face : hull.faces())
  {
    std::vector<Point> corners;
    for (const Mesh::Vertex_index v : hull.vertices_around_face(hull.halfedge(face)))
    {
      const Kernel::Point_3 & p = hull.point(v);
      corners.push_back(Point{ { p.x(), p.y(), p.z() } } - points.front());
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    sixfoldVolumes.push_back(corners.size() == 3 ? Dot(corners[0], Cross(corners[1], corners[2])) : 0.0);
  }
  std::sort(sixfoldVolumes.begin(), sixfoldVolumes.end());
  return std::abs(std::accumulate(sixfoldVolumes.begin(), sixfoldVolumes.end(), 0.0)) / 6.0;
}
} // namespace tissue
