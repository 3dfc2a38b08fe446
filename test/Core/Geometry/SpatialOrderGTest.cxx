/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/SpatialOrder.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace tissue;

namespace
{
std::vector<Point>
RandomPoints(std::size_t n)
{
  Random             random(5);
  std::vector<Point> points(n);
  for (Point & point : points)
  {
    point = { { random.Uniform(), random.Uniform(), random.Uniform() } };
  }
  return points;
}

/** Mean distance from a vertex to the next one, the exterior left out. */
double
MeanStep(const std::vector<VertexId> & order, const std::vector<Point> & centers)
{
  double sum = 0.0;
  for (std::size_t i = 2; i < order.size(); ++i)
  {
    sum += Distance(centers[order[i - 1]], centers[order[i]]);
  }
  return sum / static_cast<double>(order.size() - 2);
}
} // namespace

TEST(SpatialOrder, HasEveryVertexOnceTheExteriorFirst)
{
  std::vector<VertexId> order = SpatialOrder(RandomPoints(500));
  EXPECT_EQ(order[0], ExteriorVertex);
  std::sort(order.begin(), order.end());
  std::vector<VertexId> all(500);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(order, all);
  EXPECT_EQ(SpatialOrder({}).size(), 0u);
  EXPECT_EQ(SpatialOrder({ { { 1.0, 2.0, 3.0 } } }), std::vector<VertexId>{ ExteriorVertex });
}

TEST(SpatialOrder, StepsToTheNeighborhood)
{
  constexpr std::size_t       n = 4000;
  const std::vector<Point>    centers = RandomPoints(n);
  const std::vector<VertexId> order = SpatialOrder(centers);
  // The nearest neighbour of a point is 0.035 away, any other point 0.66, in the mean.
  EXPECT_LT(MeanStep(order, centers), 0.1);
}

TEST(SpatialOrder, DependsOnThePositionsAlone)
{
  const std::vector<Point>    centers = RandomPoints(300);
  const std::vector<VertexId> order = SpatialOrder(centers);
  std::vector<Point>          reversed = centers;
  std::reverse(reversed.begin() + 1, reversed.end());
  const std::vector<VertexId> orderOfReversed = SpatialOrder(reversed);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    EXPECT_EQ(reversed[orderOfReversed[i]], centers[order[i]]);
  }
}

TEST(SpatialOrder, TurnsWithThePositions)
{
  const std::vector<Point> centers = RandomPoints(300);
  std::vector<Point>       turned = centers;
  for (Point & p : turned)
  {
    // About the third axis, then mirrored and scaled.
    p = { { 5.0 - 2.0 * (0.6 * p[0] - 0.8 * p[1]), 2.0 * (0.8 * p[0] + 0.6 * p[1]), 2.0 * p[2] - 1.0 } };
  }
  EXPECT_EQ(SpatialOrder(turned), SpatialOrder(centers));
}

TEST(SpatialOrder, OrdersPointsOfAGridThatCoincideInCoordinates)
{
  constexpr int      n = 16;
  std::vector<Point> points;
  for (int i = 0; i < n * n * n; ++i)
  {
    points.push_back(
      { { static_cast<double>(i % n), static_cast<double>(i / n % n), static_cast<double>(i / n / n) } });
  }
  const std::vector<std::int32_t> order = HilbertOrder(points);
  ASSERT_EQ(order.size(), points.size());
  EXPECT_EQ(std::set<std::int32_t>(order.begin(), order.end()).size(), points.size());
  double length = 0.0;
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    length += Distance(points[order[i - 1]], points[order[i]]);
  }
  EXPECT_LT(length, 1.5 * static_cast<double>(points.size()));
}

TEST(SpatialOrder, RanksAreItsInverse)
{
  const std::vector<VertexId> order = SpatialOrder(RandomPoints(100));
  const std::vector<VertexId> ranks = RanksInOrder(order);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    EXPECT_EQ(ranks[order[i]], static_cast<VertexId>(i));
  }
}
