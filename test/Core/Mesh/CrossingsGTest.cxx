/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/Crossings.h"
#include "TwoTriangles.h"
#include "WallSheets.h"

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

TEST(Crossings, AreThoseThatEachPairTestedHas)
{
  Random random(5);
  int    found = 0;
  for (int i = 0; i < 40; ++i)
  {
    WallMesh mesh;
    AddSheet(mesh, 4, 0.0);
    AddSheet(mesh, 4, 0.8);
    Shake(mesh, 0.02 * i, random);
    const std::vector<TrianglePair> crossings = FindCrossingsOneByOne(mesh);
    EXPECT_EQ(FindCrossings(mesh), crossings);
    found += crossings.empty() ? 0 : 1;
  }
  EXPECT_GT(found, 10);
  EXPECT_LT(found, 40);
}

TEST(Crossings, OfWallsFarFromTheGivenOnesAreLeftOut)
{
  WallMesh mesh;
  for (int wall = 0; wall < 8; ++wall)
  {
    // Each wall crosses the next, but the fourth and the fifth are far from each other.
    AddSheet(mesh, 2, wall < 4 ? 0.0 : 100.0);
    for (std::size_t p = mesh.points.size() - 9; p < mesh.points.size(); ++p)
    {
      mesh.points[p][2] += 0.1 * wall * (mesh.points[p][0] - 1.0);
    }
  }
  const auto isOf = [&](const TrianglePair & pair, WallId wall) {
    return mesh.wallOfTriangle[pair[0]] == wall || mesh.wallOfTriangle[pair[1]] == wall;
  };
  std::vector<TrianglePair> expected;
  for (const TrianglePair & pair : FindCrossingsOneByOne(mesh))
  {
    if (isOf(pair, 1))
    {
      expected.push_back(pair);
    }
  }
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(FindCrossingsOfWalls(mesh, { 1 }), expected);
}
