/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/Untangling.h"
#include "Mesh/Crossings.h"
#include "TestWallMeshes.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TwoTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace tissue_test;

namespace
{
/** Four cells, the centre of one of whose walls is pulled through the walls at its other side. */
WallMesh
TangledCells()
{
  WallMesh   mesh = FourCells();
  const auto wall = std::find_if(mesh.walls.begin(), mesh.walls.end(), [](const WallMesh::Wall & w) {
    return w.cells == VertexPair{ { 1, 2 } };
  });
  const auto at = std::find(mesh.wallOfTriangle.begin(), mesh.wallOfTriangle.end(), wall - mesh.walls.begin());
  Point &    center = mesh.points[mesh.triangles[at - mesh.wallOfTriangle.begin()][0]];
  center = -0.6 * center;
  return mesh;
}
} // namespace

TEST(Untangling, PartsTrianglesThatCross)
{
  WallMesh mesh = MakeTwoTriangles(0.9);
  ASSERT_EQ(FindCrossings(mesh).size(), 1u);
  EXPECT_EQ(Untangle(mesh, 50).after, 0);
  EXPECT_TRUE(FindCrossings(mesh).empty());
}

TEST(Untangling, LeavesAMeshWithoutCrossingsAsItIs)
{
  const WallMesh before = FourCells();
  ASSERT_TRUE(FindCrossings(before).empty());
  WallMesh mesh = before;
  EXPECT_EQ(Untangle(mesh, 50).after, 0);
  EXPECT_EQ(mesh.points, before.points);
}

TEST(Untangling, FreesATissueByMovingPointsAlone)
{
  const WallMesh before = TangledCells();
  ASSERT_GT(FindCrossings(before).size(), 2u);
  WallMesh mesh = before;
  EXPECT_EQ(Untangle(mesh, 60).after, 0);
  EXPECT_TRUE(FindCrossings(mesh).empty());
  EXPECT_EQ(mesh.triangles, before.triangles);
  EXPECT_EQ(mesh.wallOfTriangle, before.wallOfTriangle);
}

TEST(Untangling, PointsOfNoCrossingTriangleStay)
{
  // A third triangle far from the two that cross.
  WallMesh mesh = MakeTwoTriangles(0.0);
  for (const double x : { 20.0, 21.0, 22.0 })
  {
    mesh.points.push_back({ { x, x * x, 0.0 } });
    mesh.numberOfCells.push_back(CellsWithinWall);
  }
  mesh.triangles.push_back({ { 6, 7, 8 } });
  mesh.wallOfTriangle.push_back(2);
  mesh.walls.emplace_back();
  const std::vector<Point> before = mesh.points;
  EXPECT_EQ(Untangle(mesh, 50).after, 0);
  EXPECT_NE(mesh.points, before);
  for (std::size_t p = 6; p < 9; ++p)
  {
    EXPECT_EQ(mesh.points[p], before[p]);
  }
}

TEST(Untangling, WithoutSweepsItCountsTheCrossingsAlone)
{
  WallMesh                 mesh = TangledCells();
  const std::vector<Point> before = mesh.points;
  EXPECT_EQ(Untangle(mesh, 0).after, static_cast<std::int64_t>(FindCrossings(mesh).size()));
  EXPECT_EQ(mesh.points, before);
}

TEST(Untangling, TellsThePairsThatNothingCanPart)
{
  // The same three points twice.
  WallMesh mesh = MakeTwoTriangles(2.0);
  mesh.triangles.push_back({ { 2, 1, 0 } });
  mesh.wallOfTriangle.push_back(2);
  mesh.walls.emplace_back();
  ASSERT_EQ(FindCrossings(mesh), (std::vector<TrianglePair>{ { { 0, 2 } } }));
  EXPECT_EQ(Untangle(mesh, 3).after, 1);
}

TEST(Untangling, IsTheSameEachTimeAndInAnyOrderOfWork)
{
  WallMesh first = TangledCells();
  WallMesh second = first;
  WallMesh backwards = first;
  Untangle(first, 60);
  Untangle(second, 60);
  Untangle(backwards, 60, Execution(RunBackwards));
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.points, backwards.points);
}

TEST(Untangling, EndsWhereItIsHopeless)
{
  // Stars of one tissue drawn at random places: all cross, and tests of all pairs in 10 000 sweeps would take hours.
  WallMesh mesh = RandomTissue(150);
  Random   random(5);
  for (Point & point : mesh.points)
  {
    point = { { random.Uniform(), random.Uniform(), random.Uniform() } };
  }
  const auto before = FindCrossings(mesh).size();
  ASSERT_GT(before, 100000u);
  const std::int64_t left = Untangle(mesh, 10000).after;
  EXPECT_EQ(left, static_cast<std::int64_t>(before));
  EXPECT_EQ(left, static_cast<std::int64_t>(FindCrossings(mesh).size()));
}
