/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Geometry/Metric.h"

#include <cmath>
#include <limits>

namespace tissue
{
namespace
{
using Matrix = std::array<Point, 3>;

/** Makes the entries (p, q) and (q, p) zero by a rotation, which the columns of `vectors` take part in. */
void
Rotate(Matrix & a, Matrix & vectors, int p, int q)
{
  if (a[p][q] == 0.0)
  {
    return;
  }
  const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
  const double c = 1.0 / std::sqrt(t * t + 1.0);
  const double s = t * c;
  const auto   mix = [c, s](double & x, double & y) {
    const double mixed = c * x - s * y;
    y = s * x + c * y;
    x = mixed;
  };
  for (int k = 0; k < 3; ++k)
  {
    mix(a[k][p], a[k][q]);
    mix(vectors[k][p], vectors[k][q]);
  }
  for (int k = 0; k < 3; ++k)
  {
    mix(a[p][k], a[q][k]);
  }
}
} // namespace

SymmetricEigen
DecomposeSymmetric(const Metric & m)
{
  // Convergence is quadratic: a handful of sweeps reach the precision of doubles.
  constexpr int numberOfSweeps = 20;
  Matrix        a = { { { { m[0], m[1], m[2] } }, { { m[1], m[3], m[4] } }, { { m[2], m[4], m[5] } } } };
  Matrix        vectors = { { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } } };
  for (int sweep = 0; sweep < numberOfSweeps; ++sweep)
  {
    const double off = std::abs(a[0][1]) + std::abs(a[0][2]) + std::abs(a[1][2]);
    if (off <= std::numeric_limits<double>::epsilon() * (std::abs(a[0][0]) + std::abs(a[1][1]) + std::abs(a[2][2])))
    {
      break;
    }
    Rotate(a, vectors, 0, 1);
    Rotate(a, vectors, 0, 2);
    Rotate(a, vectors, 1, 2);
  }
  SymmetricEigen eigen;
  for (int i = 0; i < 3; ++i)
  {
    eigen.values[i] = a[i][i];
    eigen.vectors[i] = { { vectors[0][i], vectors[1][i], vectors[2][i] } };
  }
  return eigen;
}
} // namespace tissue
