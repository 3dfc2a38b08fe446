/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/Crossings.h"

#include "TwoTriangles.h"

#include <gtest/gtest.h>

using namespace tissue_test;

TEST(Crossings, FindsTrianglesThatCross)
{
  EXPECT_EQ(FindCrossings(MakeTwoTriangles(0.0)), (std::vector<TrianglePair>{ { { 0, 1 } } }));
  EXPECT_TRUE(FindCrossings(MakeTwoTriangles(1.5)).empty());
  // A point on a triangle is in both.
  EXPECT_EQ(FindCrossings(MakeTwoTriangles(1.0)).size(), 1u);
}

TEST(Crossings, FindsThoseOfSomeWallsAlone)
{
  const WallMesh mesh = MakeTwoTriangles(0.0);
  EXPECT_TRUE(FindCrossingsOfWalls(mesh, {}).empty());
  EXPECT_EQ(FindCrossingsOfWalls(mesh, { 1 }), FindCrossings(mesh));
}
