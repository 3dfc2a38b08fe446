/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallLines.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

TEST(WallLines, OneForEachTriangleOfTheComplex)
{
  const auto centers = RandomCenters(20, 1);
  const auto complex = DelaunayComplex(centers);
  const auto lines = CollectWallLines(StarsOf(complex, centers));
  // Each tetrahedron has four triangles, each in two tetrahedra.
  ASSERT_EQ(lines.size(), 2 * complex.NumberOfTetrahedra());
  for (const WallLine & line : lines)
  {
    EXPECT_EQ(line.points.size(), 2u);
    EXPECT_LT(line.points.front(), line.points.back());
    EXPECT_LT(line.walls[0], line.walls[1]);
    EXPECT_LT(line.walls[1], line.walls[2]);
  }
}

TEST(WallLines, FromPoleToPoleOfAnOrange)
{
  const auto lines = CollectWallLines(RoundOrange(2));
  ASSERT_EQ(lines.size(), 4u);
  for (const WallLine & line : lines)
  {
    EXPECT_EQ(line.points.size(), 9u);
    EXPECT_EQ(line.points.front(), 0);
    EXPECT_EQ(line.points.back(), 1);
  }
  // Walls 0 to 2 are the outer ones, 3 to 5 the inner ones.
  EXPECT_EQ(std::vector<WallId>(lines[3].walls.begin(), lines[3].walls.end()), (std::vector<WallId>{ 3, 4, 5 }))
    << "the axis";
  EXPECT_DOUBLE_EQ(LengthOf(lines[3], RoundOrange(2).points), 2.0);
}

TEST(WallLines, WallsInCommonOfTwoPoints)
{
  const WallMesh      mesh = Orange();
  const WallsAtPoints wallsAt(mesh);
  EXPECT_EQ(wallsAt.CountCommon(0, 1), 6) << "the poles";
  EXPECT_EQ(wallsAt.CountCommon(0, 2), 3) << "of one line";
  EXPECT_EQ(wallsAt.CountCommon(2, 3), 1) << "from line to line";
  EXPECT_EQ(wallsAt.CountCommon(2, 6), 0) << "6 is within a wall";
}
