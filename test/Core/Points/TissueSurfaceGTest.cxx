/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/TissueSurface.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace tissue_test;

namespace
{
const Box RoomyBox{ { { -6.0, -6.0, -6.0 } }, { { 6.0, 6.0, 6.0 } } };

/** The points of a jittered lattice, one a unit of volume, in a ball about the origin. */
std::vector<Point>
BallOfCells()
{
  Random             random(3);
  std::vector<Point> points;
  for (int i = 0; i < 9 * 9 * 9; ++i)
  {
    Point p{ { i % 9 - 4.0, i / 9 % 9 - 4.0, i / 81 - 4.0 } };
    for (double & value : p)
    {
      value += 0.3 * (random.Uniform() - 0.5);
    }
    if (Norm(p) < 3.6)
    {
      points.push_back(p);
    }
  }
  return points;
}

std::vector<MetricSeed>
SeedsAt(const std::vector<Point> & points, double scale)
{
  std::vector<MetricSeed> seeds(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    seeds[i].position = scale * points[i];
  }
  return seeds;
}

double
RadiusOfBall(double volume)
{
  return std::cbrt(0.75 / std::acos(-1.0) * volume);
}

std::size_t
Count(const TissueMask & mask)
{
  return std::accumulate(mask.inside.begin(), mask.inside.end(), std::size_t{ 0 });
}
} // namespace

TEST(TissueSurface, IsThatOfABallOfCells)
{
  const auto       points = BallOfCells();
  const double     radius = RadiusOfBall(static_cast<double>(points.size()));
  const TissueMask mask = TissueSurface(points, RoomyBox).MakeMask(MakeTissueGrid(RoomyBox, 0.2));
  EXPECT_NEAR(RadiusOfBall(0.008 * static_cast<double>(Count(mask))), radius, 0.2);
  const auto & size = mask.grid.size;
  for (std::int32_t z = 0; z < size[2]; ++z)
  {
    for (std::int32_t y = 0; y < size[1]; ++y)
    {
      for (std::int32_t x = 0; x < size[0]; ++x)
      {
        const double distance = Norm(mask.grid.Position(x, y, z));
        if (std::abs(distance - radius) > 1.0)
        {
          ASSERT_EQ(mask.inside[mask.grid.Offset(x, y, z)], distance < radius ? 1 : 0) << x << " " << y << " " << z;
        }
      }
    }
  }
}

TEST(TissueSurface, FollowsTheSeedsOutwardsAndInwards)
{
  const auto       points = BallOfCells();
  const TissueGrid grid = MakeTissueGrid(RoomyBox, 0.25);
  TissueSurface    outwards(points, RoomyBox);
  TissueSurface    inwards = outwards;
  TissueSurface    still = outwards;
  outwards.Follow(SeedsAt(points, 1.1));
  inwards.Follow(SeedsAt(points, 0.9));
  still.Follow(SeedsAt(points, 1.0));
  const auto before = static_cast<double>(Count(TissueSurface(points, RoomyBox).MakeMask(grid)));
  EXPECT_NEAR(Count(still.MakeMask(grid)) / before, 1.0, 0.02);
  EXPECT_GT(Count(outwards.MakeMask(grid)) / before, 1.1);
  EXPECT_LT(Count(inwards.MakeMask(grid)) / before, 0.9);
}

TEST(TissueSurface, IsNotWhereTheBoxCutsCells)
{
  const Box        tight{ { { -3.3, -3.3, -3.3 } }, { { 3.3, 3.3, 3.3 } } };
  const auto       points = BallOfCells();
  const TissueGrid grid = MakeTissueGrid(tight, 0.1);
  const auto       isInside = [&grid](const TissueSurface & surface, const Point & p) {
    const TissueMask mask = surface.MakeMask(grid);
    return mask.inside[mask.grid.OffsetAt(p)] != 0;
  };
  // A cell about (3, 0, 0) would end at 3.2 or so, even with its seed farther in.
  const Point   atSide{ { 3.28, 0.0, 0.0 } };
  TissueSurface surface(points, tight);
  EXPECT_TRUE(isInside(surface, atSide));
  surface.Follow(SeedsAt(points, 0.85));
  EXPECT_TRUE(isInside(surface, atSide));
  TissueSurface roomy(points, RoomyBox);
  roomy.Follow(SeedsAt(points, 0.85));
  EXPECT_FALSE(isInside(roomy, atSide));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_FALSE(surface.IsInner(i) && points[i][0] > 2.9) << i;
  }
}

TEST(TissueSurface, TellsInnerCellsFromThoseAtIt)
{
  const auto          points = BallOfCells();
  const TissueSurface surface(points, RoomyBox);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (Norm(points[i]) < 1.6)
    {
      EXPECT_TRUE(surface.IsInner(i)) << i;
    }
    else if (Norm(points[i]) > 3.4)
    {
      EXPECT_FALSE(surface.IsInner(i)) << i;
    }
    EXPECT_NEAR(surface.Spacing(i), 1.15, 0.35);
  }
}
