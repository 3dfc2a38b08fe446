/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CrossingGuard.h"

#include "Mesh/Crossings.h"
#include "TwoTriangles.h"

#include <gtest/gtest.h>

using namespace tissue_test;

TEST(CrossingGuard, PointsStepBackAsFarAsTheyMust)
{
  const WallMesh before = MakeTwoTriangles(2.0);
  WallMesh       mesh = MakeTwoTriangles(0.0);
  // A third of the way leaves a gap of 0.4; all of it crosses.
  EXPECT_EQ(StepBackFromCrossings(mesh, before.points, { 0.3, 0.0 }), 3);
  EXPECT_TRUE(FindCrossings(mesh).empty());
  EXPECT_NEAR(mesh.points[3][2], 0.4, 1e-12);

  mesh = MakeTwoTriangles(0.0);
  StepBackFromCrossings(mesh, before.points, { 0.9, 0.0 });
  EXPECT_EQ(mesh.points, before.points);

  mesh = MakeTwoTriangles(1.5);
  EXPECT_EQ(StepBackFromCrossings(mesh, before.points, { 0.3, 0.0 }), 0);
  EXPECT_EQ(mesh.points, MakeTwoTriangles(1.5).points);
}
