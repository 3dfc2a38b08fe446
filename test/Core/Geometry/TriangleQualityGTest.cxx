/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Geometry/TriangleQuality.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
const Point Origin{ { 0, 0, 0 } };
const Point OnX{ { 1, 0, 0 } };
const Point Apex{ { 0.5, 0.5 * std::sqrt(3.0), 0 } };
} // namespace

TEST(TriangleQuality, EquilateralIsOneCollinearIsZero)
{
  EXPECT_DOUBLE_EQ(TriangleQuality(Origin, OnX, Apex), 1.0);
  EXPECT_DOUBLE_EQ(TriangleQuality(7.0 * Origin, 7.0 * OnX, 7.0 * Apex), 1.0);
  EXPECT_EQ(TriangleQuality(Origin, OnX, 3.0 * OnX), 0.0);
  EXPECT_EQ(TriangleQuality(OnX, OnX, OnX), 0.0);
}

TEST(TriangleQuality, RightIsoscelesByHand)
{
  // Area 1/2, squares 1 + 1 + 2.
  const Point onY{ { 0, 1, 0 } };
  EXPECT_DOUBLE_EQ(TriangleQuality(Origin, OnX, onY), 0.5 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(TriangleDistortion(Origin, OnX, onY), 4.0 / 3.0);
}

TEST(TriangleQuality, DegenerateIsInfinitelyDistorted)
{
  EXPECT_TRUE(std::isinf(TriangleDistortion(Origin, OnX, 3.0 * OnX)));
}

TEST(TriangleQuality, GradientIsTheDifferenceQuotient)
{
  const Point  a{ { 0.1, 0.2, 0.3 } };
  const Point  b{ { 1.2, 0.1, -0.2 } };
  const Point  c{ { 0.4, 0.9, 0.5 } };
  const Point  gradient = TriangleDistortionGradient(a, b, c);
  const double step = 1e-6;
  for (int i = 0; i < 3; ++i)
  {
    Point up = a;
    Point down = a;
    up[i] += step;
    down[i] -= step;
    EXPECT_NEAR(gradient[i], (TriangleDistortion(up, b, c) - TriangleDistortion(down, b, c)) / (2 * step), 1e-7);
  }
}

TEST(TriangleQuality, SummaryOfTwentyTriangles)
{
  EXPECT_EQ(SummarizeTriangleQuality({}, {}).mean, 0.0);
  const std::vector<Point> points{ Origin, OnX, Apex, 3.0 * OnX };
  std::vector<Triangle>    triangles(19, { { 0, 1, 2 } });
  triangles.push_back({ { 0, 1, 3 } });
  const QualitySummary summary = SummarizeTriangleQuality(points, triangles);
  EXPECT_DOUBLE_EQ(summary.mean, 0.95);
  EXPECT_EQ(summary.least, 0.0);
  EXPECT_DOUBLE_EQ(summary.fifthPercentile, 1.0);
}
