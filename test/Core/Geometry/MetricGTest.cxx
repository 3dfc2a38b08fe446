/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Metric.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace tissue;

Metric
DrawSymmetric(Random & random)
{
  Metric matrix;
  for (double & value : matrix)
  {
    value = 2.0 * random.Uniform() - 1.0;
  }
  return matrix;
}

void
ExpectNear(const Metric & a, const Metric & b, double tolerance)
{
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    EXPECT_NEAR(a[k], b[k], tolerance) << k;
  }
}
} // namespace

TEST(Metric, DecomposesAnySymmetricMatrix)
{
  Random random(1);
  for (int trial = 0; trial < 100; ++trial)
  {
    const Metric         matrix = DrawSymmetric(random);
    const SymmetricEigen eigen = DecomposeSymmetric(matrix);
    for (int i = 0; i < 3; ++i)
    {
      const Point & v = eigen.vectors[i];
      const Point   image{ { matrix[0] * v[0] + matrix[1] * v[1] + matrix[2] * v[2],
                             matrix[1] * v[0] + matrix[3] * v[1] + matrix[4] * v[2],
                             matrix[2] * v[0] + matrix[4] * v[1] + matrix[5] * v[2] } };
      EXPECT_LT(Distance(image, eigen.values[i] * v), 1e-14);
      for (int j = 0; j < 3; ++j)
      {
        EXPECT_NEAR(Dot(v, eigen.vectors[j]), i == j ? 1.0 : 0.0, 1e-14);
      }
    }
  }
}

TEST(Metric, TakesEqualEigenvaluesAndDiagonalMatrices)
{
  const Metric same{ { 2.0, 0.0, 0.0, 2.0, 0.0, 2.0 } };
  ExpectNear(MapEigenvalues(same, [](double value) { return value; }), same, 0.0);
  const Metric diagonal{ { 1.0, 0.0, 0.0, -3.0, 0.0, 0.25 } };
  ExpectNear(
    MapEigenvalues(diagonal, [](double value) { return value * value; }), { { 1.0, 0.0, 0.0, 9.0, 0.0, 0.0625 } }, 0.0);
}

TEST(Metric, TheLogarithmOfTheExponentialIsTheMatrix)
{
  Random random(2);
  for (int trial = 0; trial < 20; ++trial)
  {
    const Metric matrix = DrawSymmetric(random);
    const Metric exponential = MapEigenvalues(matrix, [](double value) { return std::exp(value); });
    ExpectNear(MapEigenvalues(exponential, [](double value) { return std::log(value); }), matrix, 1e-13);
  }
}
