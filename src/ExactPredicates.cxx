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
using KernelPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int
Orientation(const Point & a, const Point & b, const Point & c, const Point & d)
{
  const auto toKernel = [](const Point & p) { return KernelPoint(p[0], p[1], p[2]); };
  return static_cast<int>(CGAL::orientation(toKernel(a), toKernel(b), toKernel(c), toKernel(d)));
}
} // namespace tissue
