/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallMeshOrder.h"
#include "Remeshing/LineCoarsening.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
/** Without the triangles and points that are gone. */
WallMesh
Cleaned(WallMesh mesh)
{
  std::vector<Triangle> triangles;
  std::vector<WallId>   wallOfTriangle;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (!LineCoarsening::IsGone(mesh.triangles[t]))
    {
      triangles.push_back(mesh.triangles[t]);
      wallOfTriangle.push_back(mesh.wallOfTriangle[t]);
    }
  }
  mesh.triangles = triangles;
  mesh.wallOfTriangle = wallOfTriangle;
  PutLinePointsFirst(mesh);
  return mesh;
}

WallLine
AxisOf(const WallMesh & mesh)
{
  return CollectWallLines(mesh).back();
}
} // namespace

TEST(LineCoarsening, RemovesAPointOfTheAxisInItsThreeWalls)
{
  WallMesh       mesh = RoundOrange(1);
  LineCoarsening coarsening(mesh);
  WallLine       axis = AxisOf(mesh);
  const auto     numberOfTriangles = mesh.triangles.size();
  ASSERT_EQ(axis.points.size(), 5u);
  EXPECT_TRUE(coarsening.RemovePoint(axis, 1));
  EXPECT_EQ(axis.points.size(), 4u);
  mesh = Cleaned(mesh);
  ExpectSound(mesh, 3);
  EXPECT_EQ(mesh.triangles.size(), numberOfTriangles - 3);
  EXPECT_EQ(AxisOf(mesh).points.size(), 4u);
}

TEST(LineCoarsening, TwoLinesWithTheSameEndsDoNotBothBecomeOneEdge)
{
  WallMesh       mesh = Orange();
  LineCoarsening coarsening(mesh);
  auto           lines = CollectWallLines(mesh);
  EXPECT_TRUE(coarsening.RemovePoint(lines[3], 1));
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_FALSE(coarsening.RemovePoint(lines[i], 1)) << "the poles would have two edges in a wall";
    EXPECT_EQ(lines[i].points.size(), 3u);
  }
  ExpectSound(Cleaned(mesh), 3);
}

TEST(LineCoarsening, MovesAPointAsFarAsNoTriangleTurnsOver)
{
  WallMesh       mesh = Orange();
  LineCoarsening coarsening(mesh);
  const PointId  middle = AxisOf(mesh).points[1];
  const WallMesh before = mesh;
  EXPECT_FALSE(coarsening.MovePoint(middle, { { 0.0, 0.0, 1.5 } })) << "beyond the pole";
  EXPECT_FALSE(coarsening.MovePoint(middle, { { 0.0, 0.0, 0.999 } })) << "flat triangles";
  EXPECT_EQ(mesh.points, before.points);
  EXPECT_TRUE(coarsening.MovePoint(middle, { { 0.0, 0.0, 0.5 } }));
  EXPECT_EQ(mesh.points[middle][2], 0.5);
}
