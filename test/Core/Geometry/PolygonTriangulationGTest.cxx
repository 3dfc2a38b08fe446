/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/PolygonTriangulation.h"
#include "TissueTessellationCore/Common/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

using namespace tissue;

namespace
{
using TriangleCost = std::function<double(int i, int j, int k)>;

using PlanePoint = std::array<double, 2>;
using Polygon = std::vector<PlanePoint>;

/** All triangulations of the polygon i, ..., k. */
std::vector<RingTriangulation>
AllTriangulations(int i, int k)
{
  if (k - i < 2)
  {
    return { {} };
  }
  std::vector<RingTriangulation> all;
  for (int j = i + 1; j < k; ++j)
  {
    for (const RingTriangulation & left : AllTriangulations(i, j))
    {
      for (const RingTriangulation & right : AllTriangulations(j, k))
      {
        RingTriangulation whole = left;
        whole.insert(whole.end(), right.begin(), right.end());
        whole.push_back({ { i, j, k } });
        all.push_back(whole);
      }
    }
  }
  return all;
}

double
Sum(const RingTriangulation & triangles, const TriangleCost & cost)
{
  double sum = 0.0;
  for (const Triangle & t : triangles)
  {
    sum += cost(t[0], t[1], t[2]);
  }
  return sum;
}

TriangleCost
DelaunayCostOf(const Polygon & polygon)
{
  return [polygon](int i, int j, int k) { return DelaunayCost(polygon[i], polygon[j], polygon[k]); };
}

std::set<Triangle>
DelaunayOf(const Polygon & polygon)
{
  const auto triangles = LeastCostTriangulation(static_cast<int>(polygon.size()), DelaunayCostOf(polygon));
  return { triangles.begin(), triangles.end() };
}

/** Above 0 where d lies inside the circle through the counterclockwise triangle a, b, c. */
double
InCircle(const PlanePoint & a, const PlanePoint & b, const PlanePoint & c, const PlanePoint & d)
{
  const auto row = [&d](const PlanePoint & p) {
    const double x = p[0] - d[0];
    const double y = p[1] - d[1];
    return std::array<double, 3>{ { x, y, x * x + y * y } };
  };
  const auto u = row(a);
  const auto v = row(b);
  const auto w = row(c);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}
} // namespace

TEST(PolygonTriangulation, LeastCostIsThatOfBruteForce)
{
  Random random(1);
  for (int n = 3; n <= 8; ++n)
  {
    const auto all = AllTriangulations(0, n - 1);
    for (int repeat = 0; repeat < 20; ++repeat)
    {
      std::vector<double> table(static_cast<std::size_t>(n * n * n));
      // A third of the triangles is forbidden.
      std::generate(table.begin(), table.end(), [&random] {
        return random.Uniform() < 0.33 ? std::numeric_limits<double>::infinity() : random.Uniform();
      });
      const TriangleCost cost = [&](int i, int j, int k) { return table[(i * n + j) * n + k]; };
      double             least = std::numeric_limits<double>::infinity();
      for (const auto & triangles : all)
      {
        least = std::min(least, Sum(triangles, cost));
      }
      const auto found = LeastCostTriangulation(n, cost);
      if (std::isinf(least))
      {
        EXPECT_TRUE(found.empty());
      }
      else
      {
        EXPECT_EQ(found.size(), static_cast<std::size_t>(n - 2));
        EXPECT_NEAR(Sum(found, cost), least, 1e-12);
      }
    }
  }
}

TEST(PolygonTriangulation, OfEqualSumsTheSmallerSplittingCornerWins)
{
  const auto               triangles = LeastCostTriangulation(5, [](int, int, int) { return 1.0; });
  const std::set<Triangle> found(triangles.begin(), triangles.end());
  const std::set<Triangle> fan{ { { 0, 1, 4 } }, { { 1, 2, 4 } }, { { 2, 3, 4 } } };
  EXPECT_EQ(found, fan);
}

TEST(PolygonTriangulation, NothingForFewerThanThreeCorners)
{
  EXPECT_TRUE(LeastCostTriangulation(2, [](int, int, int) { return 0.0; }).empty());
}

TEST(PolygonTriangulation, RhombusIsCutByItsShorterDiagonal)
{
  // Derived by hand: both triangles on the shorter diagonal have an acute angle opposite to it.
  EXPECT_EQ(DelaunayOf({ { { 2, 0 } }, { { 0, 1 } }, { { -2, 0 } }, { { 0, -1 } } }),
            (std::set<Triangle>{ { { 0, 1, 3 } }, { { 1, 2, 3 } } }));
  EXPECT_EQ(DelaunayOf({ { { 1, 0 } }, { { 0, 2 } }, { { -1, 0 } }, { { 0, -2 } } }),
            (std::set<Triangle>{ { { 0, 1, 2 } }, { { 0, 2, 3 } } }));
}

TEST(PolygonTriangulation, ConvexPolygonsHaveEmptyCircles)
{
  Random random(2);
  for (int n = 4; n <= 10; ++n)
  {
    // On an ellipse every polygon is convex, and no four of these points are on a circle.
    Polygon polygon;
    for (int i = 0; i < n; ++i)
    {
      const double angle = 6.283185307179586 * (i + 0.8 * random.Uniform()) / n;
      polygon.push_back({ { 2.0 * std::cos(angle), std::sin(angle) } });
    }
    const auto triangles = DelaunayOf(polygon);
    ASSERT_EQ(triangles.size(), static_cast<std::size_t>(n - 2));
    for (const Triangle & t : triangles)
    {
      for (int p = 0; p < n; ++p)
      {
        EXPECT_LE(InCircle(polygon[t[0]], polygon[t[1]], polygon[t[2]], polygon[p]), 1e-12) << n << " corners";
      }
    }
  }
}

TEST(PolygonTriangulation, DartIsCutAtItsNotch)
{
  // The notch at corner 3: only the diagonal (1, 3) is inside.
  EXPECT_EQ(DelaunayOf({ { { 2, -1 } }, { { 0, 3 } }, { { -2, -1 } }, { { 0, 0 } } }),
            (std::set<Triangle>{ { { 0, 1, 3 } }, { { 1, 2, 3 } } }));
}

TEST(PolygonTriangulation, StarShapedPolygonIsFilledByItsOwnArea)
{
  // A four-pointed star: its points cannot be joined, its notches can.
  const Polygon star{ { { 3, 0 } },  { { 0.5, 0.6 } },   { { 0, 3 } },  { { -0.6, 0.5 } },
                      { { -3, 0 } }, { { -0.5, -0.6 } }, { { 0, -3 } }, { { 0.6, -0.5 } } };
  const auto    triangles = DelaunayOf(star);
  ASSERT_EQ(triangles.size(), 6u);
  for (const Triangle & ear : { Triangle{ { 1, 2, 3 } }, Triangle{ { 3, 4, 5 } }, Triangle{ { 5, 6, 7 } } })
  {
    EXPECT_EQ(triangles.count(ear), 1u);
  }
  EXPECT_EQ(triangles.count({ { 0, 1, 7 } }), 1u);
}

TEST(PolygonTriangulation, CrossingOrClockwisePolygonIsRefused)
{
  EXPECT_TRUE(DelaunayOf({ { { 0, 0 } }, { { 1, 1 } }, { { 1, 0 } }, { { 0, 1 } } }).empty()) << "bow-tie";
  EXPECT_TRUE(DelaunayOf({ { { 0, 0 } }, { { 0, 1 } }, { { 1, 1 } }, { { 1, 0 } } }).empty()) << "clockwise";
}

TEST(PolygonTriangulation, DelaunayCostByHand)
{
  // (1 + 1 + 2) / 0.5
  EXPECT_DOUBLE_EQ(DelaunayCost({ { 0, 0 } }, { { 1, 0 } }, { { 0, 1 } }), 8.0);
  EXPECT_TRUE(std::isinf(DelaunayCost({ { 0, 0 } }, { { 0, 1 } }, { { 1, 0 } }))) << "clockwise";
  EXPECT_TRUE(std::isinf(DelaunayCost({ { 0, 0 } }, { { 1, 1 } }, { { 2, 2 } }))) << "flat";
}
