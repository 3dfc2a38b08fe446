/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CrossingGuard.h"
#include "Fitting/CrossingWalls.h"
#include "Mesh/Crossings.h"
#include "Remeshing/WallRemeshing.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
/** A square pyramid's four sides, a wall whose centre is its top, and beside them a second wall of one triangle, which
 * cuts the plane of the square from `bottom` to z = 1.
 */
WallMesh
PyramidAndTriangle(double top, double bottom)
{
  WallMesh mesh;
  mesh.points = { { { -3, -3, 0 } }, { { 3, -3, 0 } },     { { 3, 3, 0 } },      { { -3, 3, 0 } },
                  { { 0, 0, 1 } },   { { 1, 1, bottom } }, { { 1, 2, bottom } }, { { 0, 0, top } } };
  mesh.numberOfCells.assign(7, CellsAtCorner);
  mesh.numberOfCells.push_back(CellsWithinWall);
  mesh.walls = { { { { 1, 2 } } }, { { { 3, 4 } } } };
  for (int i = 0; i < 4; ++i)
  {
    mesh.triangles.push_back({ { 7, i, (i + 1) % 4 } });
    mesh.wallOfTriangle.push_back(0);
  }
  mesh.triangles.push_back({ { 4, 5, 6 } });
  mesh.wallOfTriangle.push_back(1);
  return mesh;
}
} // namespace

TEST(CrossingWalls, SmoothingUnfoldsAWall)
{
  const WallMesh old = PyramidAndTriangle(-1.0, 0.5);
  WallMesh       mesh = PyramidAndTriangle(1.3, 0.5);
  ASSERT_FALSE(FindCrossings(mesh).empty());
  EXPECT_EQ(MendCrossingWalls(mesh, old, SmoothedPoints::WholeWalls), 0);
  EXPECT_TRUE(FindCrossings(mesh).empty());
  EXPECT_EQ(mesh.points[7], (Point{ { 0, 0, 0 } })) << "the mean of its neighbours";
}

TEST(CrossingWalls, WallsThatStillCrossGoBack)
{
  const WallMesh old = PyramidAndTriangle(4.0, -0.5);
  WallMesh       mesh = PyramidAndTriangle(0.5, -0.5);
  ASSERT_TRUE(FindCrossings(old).empty());
  ASSERT_FALSE(FindCrossings(mesh).empty());
  EXPECT_EQ(MendCrossingWalls(mesh, old, SmoothedPoints::WholeWalls), 1);
  EXPECT_EQ(mesh.points, old.points);
  EXPECT_EQ(mesh.triangles, old.triangles);
}

TEST(CrossingWalls, SmoothingAroundCrossingsLeavesTheRestOfAWall)
{
  WallMesh before = PyramidAndTriangle(2.0, 0.7);
  SubdivideWalls(before, { 0.5, 10.0 });
  const auto countMoved = [&](SmoothedPoints smoothed) {
    WallMesh mesh = before;
    EXPECT_EQ(MendCrossingWalls(mesh, PyramidAndTriangle(-1.0, 0.7), smoothed), 0);
    EXPECT_TRUE(FindCrossings(mesh).empty());
    int moved = 0;
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      moved += mesh.points[p] == before.points[p] ? 0 : 1;
    }
    return moved;
  };
  ASSERT_FALSE(FindCrossings(before).empty());
  const int around = countMoved(SmoothedPoints::AroundCrossings);
  EXPECT_GT(around, 0);
  EXPECT_LT(2 * around, countMoved(SmoothedPoints::WholeWalls));
}

TEST(CrossingWalls, AMeshWithoutCrossingsStays)
{
  const WallMesh before = FourCells();
  WallMesh       mesh = before;
  EXPECT_EQ(MendCrossingWalls(mesh, before, SmoothedPoints::WholeWalls), 0);
  EXPECT_EQ(mesh.points, before.points);
}
