/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/TissueMask.h"
#include "RunBackwards.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace tissue_test;

namespace
{
constexpr double Half = 3.0;

/** A cube of 4 on a grid of 24 along each axis of a cube of 6. */
TissueMask
MaskOfCube(double depth, const Execution & execution = Execution())
{
  std::vector<Point> centers{ NoPosition };
  for (int i = 0; i < 8; ++i)
  {
    centers.push_back({ { i % 2 * 4.0 - 2.0, i / 2 % 2 * 4.0 - 2.0, i / 4 * 4.0 - 2.0 } });
  }
  const TissueGrid grid = MakeTissueGrid({ { { -Half, -Half, -Half } }, { { Half, Half, Half } } }, 0.25);
  return EstimateTissueMask(
    DelaunayComplex(centers), centers, std::vector<double>(centers.size(), depth), grid, execution);
}

double
VolumeOf(const TissueMask & mask)
{
  const auto & steps = mask.grid.steps;
  return steps[0] * steps[1] * steps[2] * std::accumulate(mask.inside.begin(), mask.inside.end(), 0.0);
}
} // namespace

TEST(TissueGrid, FillsTheBoxWithAWholeNumberOfSteps)
{
  const TissueGrid grid = MakeTissueGrid({ { { 1.0, 2.0, 3.0 } }, { { 2.0, 4.2, 3.05 } } }, 0.1);
  EXPECT_EQ(grid.size, (std::array<std::int32_t, 3>{ { 10, 22, 1 } }));
  EXPECT_LT(Distance(grid.Position(9, 21, 0), { { 1.95, 4.15, 3.025 } }), 1e-12);
  for (const std::int32_t x : { 0, 4, 9 })
  {
    EXPECT_EQ(grid.OffsetAt(grid.Position(x, 7, 0)), grid.Offset(x, 7, 0));
  }
  EXPECT_EQ(grid.OffsetAt({ { 99.0, -99.0, 3.0 } }), grid.Offset(9, 0, 0));
}

TEST(TissueMask, IsTheInsideOfTheTetrahedraAndAMargin)
{
  EXPECT_NEAR(VolumeOf(MaskOfCube(0.0)), 64.0, 1e-9);
  const double     r = 0.8;
  const double     pi = std::acos(-1.0);
  const double     rounded = 64.0 + 6 * 16.0 * r + 12 * 4.0 * pi * r * r / 4 + 4.0 / 3.0 * pi * r * r * r;
  const TissueMask mask = MaskOfCube(r);
  EXPECT_NEAR(VolumeOf(mask), rounded, 0.04 * rounded);
  const std::vector<Point> insidePoints{ { { 0.0, 0.0, 2.6 } }, { { 2.4, 2.4, 0.0 } }, { { -2.4, 2.4, -2.4 } } };
  const std::vector<Point> outsidePoints{ { { 0.0, 0.0, 2.99 } }, { { 2.7, 2.7, 0.0 } }, { { -2.6, 2.6, -2.6 } } };
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(mask.inside[mask.grid.OffsetAt(insidePoints[i])], 1) << i;
    EXPECT_EQ(mask.inside[mask.grid.OffsetAt(outsidePoints[i])], 0) << i;
  }
}

TEST(TissueMask, IsCutByTheBox)
{
  EXPECT_NEAR(VolumeOf(MaskOfCube(5.0)), 216.0, 1e-9);
}

TEST(TissueMask, IsTheSameInAnyOrderOfItsParts)
{
  EXPECT_EQ(MaskOfCube(0.6).inside, MaskOfCube(0.6, Execution(tissue_test::RunBackwards)).inside);
}

TEST(TissueMask, IsSampledInSmallGroups)
{
  const TissueMask    mask = MaskOfCube(0.6);
  const TissueSamples samples = SampleMask(mask);
  EXPECT_EQ(samples.boxSize, mask.grid.steps);
  std::vector<std::uint8_t> inside(mask.inside.size(), 0);
  std::size_t               i = 0;
  for (const TissueSamples::Group & group : samples.groups)
  {
    for (; i < group.end; ++i)
    {
      ++inside[mask.grid.OffsetAt(samples.points[i])];
      EXPECT_LE(Distance(samples.points[i], group.center), group.radius * (1 + 1e-12));
    }
  }
  EXPECT_EQ(i, samples.points.size());
  EXPECT_EQ(inside, mask.inside);
}
