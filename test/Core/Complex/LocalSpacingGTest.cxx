/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/LocalSpacing.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
/** By all distances. */
double
MeanOfNearest(const std::vector<Point> & centers, std::size_t vertex, std::size_t number)
{
  std::vector<double> distances;
  for (std::size_t v = 1; v < centers.size(); ++v)
  {
    if (v != vertex)
    {
      distances.push_back(Distance(centers[vertex], centers[v]));
    }
  }
  std::sort(distances.begin(), distances.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < number; ++i)
  {
    sum += distances[i];
  }
  return sum / static_cast<double>(number);
}
} // namespace

TEST(LocalSpacing, IsTheMeanDistanceOfTheEightNearest)
{
  Random             random(4);
  std::vector<Point> centers{ NoPosition };
  for (int i = 0; i < 400; ++i)
  {
    // Flat and of uneven density: the nearest are not all neighbours.
    const double x = random.Uniform();
    const double y = random.Uniform();
    centers.push_back({ { x * x * x, y, 0.05 * random.Uniform() } });
  }
  const auto spacings = LocalSpacings(DelaunayComplex(centers), centers);
  ASSERT_EQ(spacings.size(), centers.size());
  EXPECT_EQ(spacings[ExteriorVertex], 0.0);
  for (std::size_t v = 1; v < centers.size(); ++v)
  {
    EXPECT_NEAR(spacings[v], MeanOfNearest(centers, v, 8), 1e-12) << v;
  }
}

TEST(LocalSpacing, IsOfAllOthersWhereThereAreFewer)
{
  const auto spacings = LocalSpacings(DelaunayComplex(RegularTetrahedron()), RegularTetrahedron());
  EXPECT_NEAR(spacings[2], 2.0 * std::sqrt(2.0), 1e-12);
}

TEST(LocalSpacing, MedianLeavesOutTheExterior)
{
  EXPECT_EQ(MedianSpacing({ 0.0, 7.0, 1.0, 3.0, 5.0 }), 5.0);
}
