/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/ConvexHull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <cmath>

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
  // The volume is the sum over the facets of the tetrahedra from the origin. CGAL keeps facets by their addresses, so
  // that each run has them in another order: exact numbers have the same sum in any.
  using Number = CGAL::MP_Float;
  Number sixfoldVolume = 0;
  for (const Mesh::Face_index face : hull.faces())
  {
    std::vector<std::array<Number, 3>> p;
    for (const Mesh::Vertex_index v : hull.vertices_around_face(hull.halfedge(face)))
    {
      const Kernel::Point_3 & corner = hull.point(v);
      p.push_back({ { corner.x(), corner.y(), corner.z() } });
    }
    if (p.size() == 3)
    {
      sixfoldVolume += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                       p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                       p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
  }
  return std::abs(CGAL::to_double(sixfoldVolume)) / 6.0;
}
} // namespace tissue
