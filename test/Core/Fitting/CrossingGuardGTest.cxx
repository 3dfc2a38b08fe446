/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CrossingGuard.h"
#include "Mesh/Crossings.h"
#include "TwoTriangles.h"
#include "WallSheets.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
constexpr AngleLimits NoLimits{ 0.0, 0.0, 0.0 };
constexpr AngleLimits TenDegrees{ 10.0, 10.0, 0.0 };

/** Two triangles with an edge of length 2 in common: a flat one, and one whose point is at a place. */
WallMesh
MakeHinge(const Point & place)
{
  WallMesh mesh;
  mesh.points = { { { -1, 0, 0 } }, { { 1, 0, 0 } }, { { 0, -1, 0 } }, place };
  mesh.triangles = { { { 1, 0, 2 } }, { { 0, 1, 3 } } };
  mesh.wallOfTriangle = { 0, 0 };
  mesh.walls.resize(1);
  mesh.numberOfCells.assign(4, CellsWithinWall);
  return mesh;
}
} // namespace

TEST(CrossingGuard, PointsStepBackAsFarAsTheyMust)
{
  const WallMesh before = MakeTwoTriangles(2.0);
  WallMesh       mesh = MakeTwoTriangles(0.0);
  // A third of the way leaves a gap of 0.4; all of it crosses.
  EXPECT_EQ(StepBackFromCrossings(mesh, before.points, { 0.3, 0.0 }, NoLimits), 3);
  EXPECT_TRUE(FindCrossings(mesh).empty());
  EXPECT_NEAR(mesh.points[3][2], 0.4, 1e-12);

  mesh = MakeTwoTriangles(0.0);
  StepBackFromCrossings(mesh, before.points, { 0.9, 0.0 }, NoLimits);
  EXPECT_EQ(mesh.points, before.points);

  mesh = MakeTwoTriangles(1.5);
  EXPECT_EQ(StepBackFromCrossings(mesh, before.points, { 0.3, 0.0 }, NoLimits), 0);
  EXPECT_EQ(mesh.points, MakeTwoTriangles(1.5).points);
}

TEST(CrossingGuard, NoFoldAndNoSliverIsMadeOrMadeWorse)
{
  const WallMesh before = MakeHinge({ { 0, 1, 0 } });
  const Point    folded{ { 0, -1, 0.1 } };
  const Point    sliver{ { 0, 0.05, 0 } };
  for (const Point & place : { folded, sliver })
  {
    WallMesh mesh = MakeHinge(place);
    EXPECT_EQ(StepBackFromCrossings(mesh, before.points, { 0.0 }, NoLimits), 0);
    EXPECT_EQ(StepBackFromCrossings(mesh, before.points, { 0.0 }, TenDegrees), 1);
    EXPECT_EQ(mesh.points, before.points);
  }
}

TEST(CrossingGuard, WhatIsSharpMayGetBetter)
{
  const WallMesh folded = MakeHinge({ { 0, -1, 0.05 } });
  WallMesh       mesh = MakeHinge({ { 0, -1, 0.1 } });
  EXPECT_EQ(StepBackFromCrossings(mesh, folded.points, { 0.0 }, TenDegrees), 0);
  const WallMesh sliver = MakeHinge({ { 0, 0.02, 0 } });
  mesh = MakeHinge({ { 0, 0.05, 0 } });
  EXPECT_EQ(StepBackFromCrossings(mesh, sliver.points, { 0.0 }, TenDegrees), 0);
}

TEST(CrossingGuard, LeavesNothingOfRandomMotionsThatCrosses)
{
  Random random(7);
  int    steppedBack = 0;
  for (int i = 0; i < 40; ++i)
  {
    WallMesh mesh;
    AddSheet(mesh, 4, 0.0);
    AddSheet(mesh, 4, 0.7);
    const std::vector<Point> before = mesh.points;
    Shake(mesh, 0.03 * i, random);
    const bool isAny = !FindCrossingsOneByOne(mesh).empty();
    steppedBack += StepBackFromCrossings(mesh, before, { 0.3, 0.0 }, NoLimits) > 0 ? 1 : 0;
    EXPECT_TRUE(!isAny || steppedBack > 0);
    EXPECT_TRUE(FindCrossingsOneByOne(mesh).empty());
  }
  EXPECT_GT(steppedBack, 10);
}
