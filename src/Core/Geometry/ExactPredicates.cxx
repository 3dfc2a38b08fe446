/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/ExactPredicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <variant>

namespace tissue
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using KernelPoint = Kernel::Point_3;
using Hull = std::variant<KernelPoint, Kernel::Segment_3, Kernel::Triangle_3>;

KernelPoint
ToKernel(const Point & p)
{
  return { p[0], p[1], p[2] };
}

/** Returns what the triangle covers, which is a segment or a point where its corners are on one line. */
Hull
ToHull(const std::array<Point, 3> & triangle)
{
  std::array<KernelPoint, 3> p{ { ToKernel(triangle[0]), ToKernel(triangle[1]), ToKernel(triangle[2]) } };
  if (!CGAL::collinear(p[0], p[1], p[2]))
  {
    return Kernel::Triangle_3(p[0], p[1], p[2]);
  }
  std::sort(p.begin(), p.end()); // This is their order along their line.
  return p[0] == p[2] ? Hull(p[0]) : Hull(Kernel::Segment_3(p[0], p[2]));
}
} // namespace

int
Orientation(const Point & a, const Point & b, const Point & c, const Point & d)
{
  return static_cast<int>(CGAL::orientation(ToKernel(a), ToKernel(b), ToKernel(c), ToKernel(d)));
}

bool
TrianglesMeet(const std::array<Point, 3> & s, const std::array<Point, 3> & t)
{
  return std::visit([](const auto & a, const auto & b) { return CGAL::do_intersect(a, b); }, ToHull(s), ToHull(t));
}

bool
AreOnOneSide(const Point & a, const Point & b, const Point & c, const Point & d)
{
  const KernelPoint p = ToKernel(a);
  const KernelPoint q = ToKernel(b);
  const KernelPoint r = ToKernel(c);
  return !CGAL::collinear(p, q, r) && CGAL::coplanar_orientation(p, q, r, ToKernel(d)) == CGAL::POSITIVE;
}

bool
AreCoplanar(const std::vector<Point> & points)
{
  // Each point outside of what the basis spans, a point, a line or a plane, is added to it; a fourth one settles it.
  std::vector<KernelPoint> basis;
  for (const Point & point : points)
  {
    const KernelPoint p = ToKernel(point);
    const bool        isOutside = basis.empty() || (basis.size() == 1 && p != basis[0]) ||
                           (basis.size() == 2 && !CGAL::collinear(basis[0], basis[1], p)) ||
                           (basis.size() == 3 && !CGAL::coplanar(basis[0], basis[1], basis[2], p));
    if (isOutside)
    {
      basis.push_back(p);
    }
    if (basis.size() == 4)
    {
      return false;
    }
  }
  return true;
}
} // namespace tissue
