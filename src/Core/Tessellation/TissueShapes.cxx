/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Tessellation/TissueShapes.h"

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
struct Ellipsoid
{
  Point center;
  Point semiAxes;
};

/** Approximates the signed distance to the ellipsoid, well enough to blend shapes with. The distance in units of the
 * semi-axes is scaled by the least of them. */
double
Distance(const Ellipsoid & ellipsoid, const Point & point)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double x = (point[i] - ellipsoid.center[i]) / ellipsoid.semiAxes[i];
    sum += x * x;
  }
  return (std::sqrt(sum) - 1.0) * *std::min_element(ellipsoid.semiAxes.begin(), ellipsoid.semiAxes.end());
}

/** Gives the lesser of two distances, and a little less where they are within `width` of each other, which rounds the
 * joint. */
double
SmoothMinimum(double a, double b, double width)
{
  const double overlap = std::max(width - std::abs(a - b), 0.0);
  return std::min(a, b) - overlap * overlap / (4.0 * width);
}
} // namespace

bool
IsInsideDome(const Point & point)
{
  // The dome is two half ellipsoids, one above and one below its widest level: a low base and a high top.
  constexpr double waist = -0.6;
  const double     z = (point[2] - waist) / (point[2] > waist ? 1.0 - waist : 1.0 + waist);
  return point[0] * point[0] + point[1] * point[1] + z * z <= 1.0;
}

bool
IsInsideFlower(const Point & point)
{
  // Sepals reach the sides of the cube, 0.58 + 0.42 = 1, and meet the central dome with a joint rounded within 0.08.
  constexpr double jointWidth = 0.08;
  const Ellipsoid  center = { { { 0.0, 0.0, -0.2 } }, { { 0.45, 0.45, 0.8 } } };
  constexpr double ring = 0.58;
  const Ellipsoid  sepals[] = { { { { ring, 0.0, 0.0 } }, { { 0.42, 0.42, 1.0 } } },
                                { { { -ring, 0.0, 0.0 } }, { { 0.42, 0.42, 1.0 } } },
                                { { { 0.0, ring, 0.0 } }, { { 0.42, 0.42, 1.0 } } },
                                { { { 0.0, -ring, 0.0 } }, { { 0.42, 0.42, 1.0 } } } };
  double           distance = Distance(center, point);
  for (const Ellipsoid & sepal : sepals)
  {
    distance = SmoothMinimum(distance, Distance(sepal, point), jointWidth);
  }
  return distance <= 0.0;
}
} // namespace tissue
