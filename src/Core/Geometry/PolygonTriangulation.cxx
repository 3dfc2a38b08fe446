/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/PolygonTriangulation.h"

#include <limits>

namespace tissue
{
double
DelaunayCost(const std::array<double, 2> & a, const std::array<double, 2> & b, const std::array<double, 2> & c)
{
  const auto squaredLength = [](const std::array<double, 2> & p, const std::array<double, 2> & q) {
    return (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]);
  };
  const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  return area > 0.0 ? (squaredLength(a, b) + squaredLength(b, c) + squaredLength(c, a)) / area
                    : std::numeric_limits<double>::infinity();
}
} // namespace tissue
