/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Tessellation/CellMoments.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Tessellation/AnisotropicTessellation.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace tissue;
using SeedId = AnisotropicTessellation::SeedId;

Point
DrawPoint(Random & random, double size)
{
  const double x = size * random.Uniform();
  const double y = size * random.Uniform();
  const double z = size * random.Uniform();
  return { { x, y, z } };
}

/** B'B + 0.1 of a random B: eigenvalues spread over two orders of magnitude. */
Metric
DrawMetric(Random & random)
{
  const Point a = DrawPoint(random, 1.0);
  const Point b = DrawPoint(random, 1.0);
  const Point c = DrawPoint(random, 1.0);
  return { { Dot(a, a) + 0.1, Dot(a, b), Dot(a, c), Dot(b, b) + 0.1, Dot(b, c), Dot(c, c) + 0.1 } };
}

SeedId
FindNearestOfAll(const std::vector<MetricSeed> & seeds, const Point & point)
{
  SeedId nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const double distance = QuadraticForm(seeds[i].metric, point - seeds[i].position);
    if (distance < least)
    {
      least = distance;
      nearest = static_cast<SeedId>(i);
    }
  }
  return nearest;
}
} // namespace

TEST(AnisotropicTessellation, CandidatesOfABallHoldTheNearestSeedOfEachOfItsPoints)
{
  Random                  random(1);
  std::vector<MetricSeed> seeds(300);
  for (MetricSeed & seed : seeds)
  {
    seed = { DrawPoint(random, 10.0), DrawMetric(random) };
  }
  const AnisotropicTessellation tessellation(seeds);
  std::vector<SeedId>           candidates;
  std::size_t                   numberOfCandidates = 0;
  for (int ball = 0; ball < 200; ++ball)
  {
    // Some are off the seeds' box.
    const Point  center = DrawPoint(random, 14.0) - Point{ { 2.0, 2.0, 2.0 } };
    const double radius = random.Uniform();
    tessellation.FindCandidates(center, radius, candidates);
    numberOfCandidates += candidates.size();
    for (int i = 0; i < 50; ++i)
    {
      const Point offset = DrawPoint(random, 2.0) - Point{ { 1.0, 1.0, 1.0 } };
      const Point point = center + radius * random.Uniform() * Normalized(offset);
      ASSERT_EQ(tessellation.FindNearest(point, candidates), FindNearestOfAll(seeds, point));
    }
  }
  EXPECT_LT(numberOfCandidates, 200 * seeds.size() / 3) << "the look-up spares nothing";
}

TEST(AnisotropicTessellation, MetricDecidesWhichSeedIsNear)
{
  // By hand: from the origin to a seed at (3, 0, 0) of a metric that counts x by 1/4 (3^2 / 4 = 2.25), to one at
  // (0, 2, 0) of the usual one (4).
  const MetricSeed              far = { { { 3.0, 0.0, 0.0 } }, { { 0.25, 0.0, 0.0, 1.0, 0.0, 1.0 } } };
  const MetricSeed              near = { { { 0.0, 2.0, 0.0 } }, { { 1.0, 0.0, 0.0, 1.0, 0.0, 1.0 } } };
  const AnisotropicTessellation tessellation({ near, far });
  std::vector<SeedId>           candidates;
  tessellation.FindCandidates({ { 0.0, 0.0, 0.0 } }, 0.0, candidates);
  EXPECT_EQ(tessellation.FindNearest({ { 0.0, 0.0, 0.0 } }, candidates), 1);
}

TEST(AnisotropicTessellation, FirstOfEquallyNearSeedsWins)
{
  const MetricSeed              left = { { { -1.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0, 1.0, 0.0, 1.0 } } };
  const MetricSeed              right = { { { 1.0, 0.0, 0.0 } }, left.metric };
  const AnisotropicTessellation tessellation({ right, left, left });
  EXPECT_EQ(tessellation.FindNearest({ { 0.0, 0.0, 0.0 } }, { 2, 1, 0 }), 0);
  EXPECT_EQ(tessellation.FindNearest({ { -1.0, 0.0, 0.0 } }, { 2, 1, 0 }), 1);
}

TEST(Metric, InverseTimesTheMatrixIsTheIdentity)
{
  Random       random(2);
  const Metric m = DrawMetric(random);
  const Metric n = Inverse(m);
  EXPECT_NEAR(m[0] * n[0] + m[1] * n[1] + m[2] * n[2], 1.0, 1e-12);
  EXPECT_NEAR(m[0] * n[1] + m[1] * n[3] + m[2] * n[4], 0.0, 1e-12);
  EXPECT_NEAR(m[1] * n[1] + m[3] * n[3] + m[4] * n[4], 1.0, 1e-12);
  EXPECT_NEAR(m[1] * n[2] + m[3] * n[4] + m[4] * n[5], 0.0, 1e-12);
  EXPECT_NEAR(m[2] * n[2] + m[4] * n[4] + m[5] * n[5], 1.0, 1e-12);
}

TEST(CellMoments, AreThoseOfTheBoxesAboutThePoints)
{
  // Cell 0: two boxes of 2 x 1 x 1 side by side, which are one of 4 x 1 x 1: variance 16 / 12 along x, 1 / 12 else.
  // Cell 1: one box. Cell 2: none.
  const std::vector<Point> points = { { { 1.0, 5.0, 0.0 } }, { { 3.0, 5.0, 0.0 } }, { { 7.0, 8.0, 9.0 } } };
  const auto               cells = MeasureCells(points, { 0, 0, 1 }, 3, { { 2.0, 1.0, 1.0 } });
  ASSERT_EQ(cells.size(), 3u);
  EXPECT_EQ(cells[0].numberOfPoints, 2u);
  EXPECT_EQ(cells[0].mean, (Point{ { 2.0, 5.0, 0.0 } }));
  EXPECT_NEAR(cells[0].covariance[0], 16.0 / 12.0, 1e-12);
  EXPECT_EQ(cells[0].covariance[1], 0.0);
  EXPECT_NEAR(cells[0].covariance[3], 1.0 / 12.0, 1e-12);
  EXPECT_EQ(cells[1].mean, points[2]);
  EXPECT_NEAR(cells[1].covariance[0], 4.0 / 12.0, 1e-12);
  EXPECT_EQ(cells[2].numberOfPoints, 0u);
}
