/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/ExactPredicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace tissue
{
namespace
{
using KernelPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

KernelPoint
ToKernel(const Point & p)
{
  return { p[0], p[1], p[2] };
}
} // namespace

int
Orientation(const Point & a, const Point & b, const Point & c, const Point & d)
{
  return static_cast<int>(CGAL::orientation(ToKernel(a), ToKernel(b), ToKernel(c), ToKernel(d)));
}

bool
AreCoplanar(const std::vector<Point> & points)
{
  // Points are added to a basis as long as they are outside of what it spans.
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
