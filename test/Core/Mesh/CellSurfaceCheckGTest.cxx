/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

// All figures are derived by hand. A lone unit cube has 8 points, 12 triangles, 18 edges, area 6 and volume 1.

namespace
{
tissue::WallMesh
MakeTwoCubes()
{
  return MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
}

std::string
RefusalOf(const tissue::WallMesh & mesh, tissue::VertexId numberOfVertices)
{
  try
  {
    tissue::CheckCellSurfaces(mesh, numberOfVertices);
  }
  catch (const std::invalid_argument & error)
  {
    return error.what();
  }
  return "accepted";
}
} // namespace

TEST(CellSurfaceCheck, TwoHalvesOfABlockAreSound)
{
  const auto check = tissue::CheckCellSurfaces(MakeTwoCubes(), 3);
  ASSERT_EQ(check.cells.size(), 3u);
  EXPECT_EQ(check.cells[0].numberOfTriangles, 0);
  EXPECT_FALSE(check.cells[0].IsClosed());
  for (const tissue::VertexId cell : { 1, 2 })
  {
    const tissue::CellSurface & surface = check.cells[cell];
    EXPECT_EQ(surface.numberOfTriangles, 12);
    EXPECT_EQ(surface.numberOfWalls, 2);
    EXPECT_EQ(surface.numberOfComponents, 1);
    EXPECT_EQ(surface.eulerCharacteristic, 2);
    EXPECT_DOUBLE_EQ(surface.area, 6.0);
    EXPECT_DOUBLE_EQ(surface.volume, 1.0);
    EXPECT_TRUE(surface.IsClosed());
    EXPECT_TRUE(surface.IsSphere());
  }
  EXPECT_TRUE(check.IsSound());
}

TEST(CellSurfaceCheck, VolumeDoesNotDependOnWhereTheTissueLies)
{
  tissue::WallMesh mesh = MakeTwoCubes();
  for (tissue::Point & point : mesh.points)
  {
    point = { { point[0] + (1 << 30), point[1] - (1 << 29), point[2] + (1 << 28) } };
  }
  EXPECT_DOUBLE_EQ(tissue::CheckCellSurfaces(mesh, 3).cells[1].volume, 1.0);
}

TEST(CellSurfaceCheck, AHoleHasThreeOpenEdgesAndOpensTheCellAlone)
{
  tissue::WallMesh mesh = MakeTwoCubes();
  // The last triangle belongs to the last wall, of cell 2 and the exterior.
  mesh.triangles.pop_back();
  mesh.wallOfTriangle.pop_back();
  const auto check = tissue::CheckCellSurfaces(mesh, 3);
  EXPECT_TRUE(check.cells[1].IsSphere());
  EXPECT_EQ(check.cells[2].numberOfOpenEdges, 3);
  EXPECT_EQ(check.cells[2].numberOfTriangles, 11);
  EXPECT_EQ(check.cells[2].eulerCharacteristic, 1);
  EXPECT_DOUBLE_EQ(check.cells[2].area, 5.5);
  EXPECT_FALSE(check.cells[2].IsClosed());
  EXPECT_EQ(check.cellsThatAreNoSphere, std::vector<tissue::VertexId>{ 2 });
  EXPECT_FALSE(check.IsSound());
}

TEST(CellSurfaceCheck, ATriangleTurnedOverHasThreeMisorientedEdgesInBothItsCells)
{
  tissue::WallMesh mesh = MakeTwoCubes();
  // Walls are sorted: (1, exterior), (1, 2), (2, exterior).
  const auto wall = std::find(mesh.wallOfTriangle.begin(), mesh.wallOfTriangle.end(), 1);
  auto &     triangle = mesh.triangles[wall - mesh.wallOfTriangle.begin()];
  std::swap(triangle[0], triangle[1]);
  const auto check = tissue::CheckCellSurfaces(mesh, 3);
  for (const tissue::VertexId cell : { 1, 2 })
  {
    EXPECT_EQ(check.cells[cell].numberOfMisorientedEdges, 3);
    EXPECT_EQ(check.cells[cell].numberOfOpenEdges, 0);
    EXPECT_EQ(check.cells[cell].eulerCharacteristic, 2);
    EXPECT_FALSE(check.cells[cell].IsClosed());
  }
}

TEST(CellSurfaceCheck, ACellTurnedInsideOutHasNegativeVolume)
{
  tissue::WallMesh mesh = MakeVoxelWallMesh({ { 1, 1, 1 } }, { 1 });
  for (auto & triangle : mesh.triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  const auto check = tissue::CheckCellSurfaces(mesh, 2);
  EXPECT_DOUBLE_EQ(check.cells[1].volume, -1.0);
  EXPECT_TRUE(check.cells[1].IsSphere());
}

TEST(CellSurfaceCheck, ATorusIsClosedButNoSphere)
{
  const auto check = tissue::CheckCellSurfaces(MakeVoxelWallMesh({ { 3, 3, 1 } }, { 1, 1, 1, 1, 0, 1, 1, 1, 1 }), 2);
  EXPECT_TRUE(check.cells[1].IsClosed());
  EXPECT_EQ(check.cells[1].eulerCharacteristic, 0);
  EXPECT_DOUBLE_EQ(check.cells[1].volume, 8.0);
  EXPECT_FALSE(check.cells[1].IsSphere());
  EXPECT_FALSE(check.cells[1].HasOnlySpheres());
  EXPECT_EQ(check.cellsThatAreNoSphere, std::vector<tissue::VertexId>{ 1 });
}

TEST(CellSurfaceCheck, ACellAroundAnotherHasTwoComponentsAndIsSound)
{
  std::vector<tissue::VertexId> vertices(27, 1);
  vertices[13] = 2;
  const auto check = tissue::CheckCellSurfaces(MakeVoxelWallMesh({ { 3, 3, 3 } }, vertices), 3);
  EXPECT_EQ(check.cells[1].numberOfComponents, 2);
  EXPECT_EQ(check.cells[1].eulerCharacteristic, 4);
  EXPECT_DOUBLE_EQ(check.cells[1].volume, 26.0);
  EXPECT_TRUE(check.cells[1].IsClosed());
  EXPECT_FALSE(check.cells[1].IsSphere());
  EXPECT_TRUE(check.cells[1].HasOnlySpheres());
  EXPECT_TRUE(check.cells[2].IsSphere());
  EXPECT_TRUE(check.IsSound());
}

TEST(CellSurfaceCheck, ASphereAndATorusAreNotOnlySpheres)
{
  // The torus and, apart from it, a cube.
  const auto check =
    tissue::CheckCellSurfaces(MakeVoxelWallMesh({ { 5, 3, 1 } }, { 1, 1, 1, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 0, 0 }), 2);
  EXPECT_TRUE(check.cells[1].IsClosed());
  EXPECT_EQ(check.cells[1].numberOfComponents, 2);
  EXPECT_EQ(check.cells[1].eulerCharacteristic, 2);
  EXPECT_FALSE(check.cells[1].HasOnlySpheres());
  EXPECT_FALSE(check.cells[1].IsSphere());
}

TEST(CellSurfaceCheck, VoxelsThatTouchAlongAnEdgeAreClosedButNoSpheres)
{
  const auto check = tissue::CheckCellSurfaces(MakeVoxelWallMesh({ { 2, 2, 1 } }, { 1, 0, 0, 1 }), 2);
  EXPECT_EQ(check.cells[1].numberOfCrowdedEdges, 1);
  EXPECT_TRUE(check.cells[1].IsClosed());
  EXPECT_DOUBLE_EQ(check.cells[1].volume, 2.0);
  EXPECT_FALSE(check.cells[1].HasOnlySpheres());
  EXPECT_EQ(check.cellsThatAreNoSphere, std::vector<tissue::VertexId>{ 1 });
}

TEST(CellSurfaceCheck, ATriangleTooManyIsNotClosed)
{
  tissue::WallMesh mesh = MakeVoxelWallMesh({ { 1, 1, 1 } }, { 1 });
  // Twice the same, so that each of its edges is in three triangles.
  mesh.triangles.push_back(mesh.triangles.back());
  mesh.wallOfTriangle.push_back(mesh.wallOfTriangle.back());
  const auto check = tissue::CheckCellSurfaces(mesh, 2);
  EXPECT_EQ(check.cells[1].numberOfOpenEdges, 0);
  EXPECT_EQ(check.cells[1].numberOfMisorientedEdges, 3);
  EXPECT_FALSE(check.cells[1].IsClosed());
}

TEST(CellSurfaceCheck, VoxelsThatTouchAtAPointAreTwoComponents)
{
  const auto check = tissue::CheckCellSurfaces(MakeVoxelWallMesh({ { 2, 2, 2 } }, { 1, 0, 0, 0, 0, 0, 0, 1 }), 2);
  EXPECT_TRUE(check.cells[1].IsClosed());
  EXPECT_EQ(check.cells[1].numberOfComponents, 2);
  // 15 points, 36 edges, 24 triangles.
  EXPECT_EQ(check.cells[1].eulerCharacteristic, 3);
  EXPECT_FALSE(check.cells[1].IsSphere());
  EXPECT_FALSE(check.cells[1].HasOnlySpheres());
}

TEST(CellSurfaceCheck, FourCubesAroundAnEdgeCrowdItsTwoEnds)
{
  // The exterior is the fifth cell at both ends of the edge.
  tissue::WallMesh mesh = MakeVoxelWallMesh({ { 2, 2, 1 } }, { 1, 2, 3, 4 });
  auto             check = tissue::CheckCellSurfaces(mesh, 5);
  ASSERT_EQ(check.crowdedPoints.size(), 2u);
  for (const tissue::PointId point : check.crowdedPoints)
  {
    EXPECT_EQ(mesh.points[point][0], 1.0);
    EXPECT_EQ(mesh.points[point][1], 1.0);
  }
  EXPECT_TRUE(check.cellsThatAreNoSphere.empty());
  EXPECT_EQ(check.numberOfMiscountedPoints, 0);
  EXPECT_FALSE(check.IsSound());

  mesh.numberOfCells[check.crowdedPoints[0]] = 4;
  EXPECT_EQ(tissue::CheckCellSurfaces(mesh, 5).numberOfMiscountedPoints, 1);
  mesh.numberOfCells.clear();
  EXPECT_EQ(tissue::CheckCellSurfaces(mesh, 5).numberOfMiscountedPoints, 0);
}

TEST(CellSurfaceCheck, CellsWithoutTrianglesAndUnusedPointsAreFound)
{
  tissue::WallMesh mesh = MakeTwoCubes();
  mesh.points.push_back({ { 9, 9, 9 } });
  mesh.numberOfCells.push_back(0);
  const auto check = tissue::CheckCellSurfaces(mesh, 5);
  EXPECT_EQ(check.cellsWithoutTriangles, (std::vector<tissue::VertexId>{ 3, 4 }));
  EXPECT_TRUE(check.cellsThatAreNoSphere.empty());
  EXPECT_EQ(check.numberOfUnusedPoints, 1);
  EXPECT_EQ(check.numberOfMiscountedPoints, 0);
  EXPECT_FALSE(check.IsSound());
}

TEST(CellSurfaceCheck, DegenerateTrianglesAreCounted)
{
  tissue::WallMesh mesh = MakeTwoCubes();
  const auto       triangle = mesh.triangles[0];
  mesh.triangles[0][2] = triangle[0];
  EXPECT_EQ(tissue::CheckCellSurfaces(mesh, 3).numberOfDegenerateTriangles, 1);

  mesh.triangles[0] = triangle;
  const tissue::Point a = mesh.points[triangle[0]];
  const tissue::Point b = mesh.points[triangle[1]];
  mesh.points.push_back({ { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 } });
  mesh.numberOfCells.clear();
  mesh.triangles[0][2] = static_cast<tissue::PointId>(mesh.points.size() - 1);
  EXPECT_EQ(tissue::CheckCellSurfaces(mesh, 3).numberOfDegenerateTriangles, 1);
}

TEST(CellSurfaceCheck, MeshesThatCannotBeReadAreRefusedByName)
{
  const tissue::WallMesh good = MakeTwoCubes();
  EXPECT_EQ(RefusalOf(good, 3), "accepted");
  EXPECT_NE(RefusalOf(good, 0).find("number of vertices is 0"), std::string::npos);
  EXPECT_NE(RefusalOf(good, 2).find("is 2, must be at least 0 and below 2"), std::string::npos);

  tissue::WallMesh mesh = good;
  mesh.triangles[5][1] = 12;
  EXPECT_EQ(RefusalOf(mesh, 3), "Wall mesh: a point of triangle 5 is 12, must be at least 0 and below 12");
  mesh = good;
  mesh.wallOfTriangle[4] = -1;
  EXPECT_EQ(RefusalOf(mesh, 3), "Wall mesh: the wall of triangle 4 is -1, must be at least 0 and below 3");
  mesh = good;
  mesh.wallOfTriangle.pop_back();
  EXPECT_NE(RefusalOf(mesh, 3).find("length of wallOfTriangle is 21"), std::string::npos);
  mesh = good;
  mesh.numberOfCells.pop_back();
  EXPECT_NE(RefusalOf(mesh, 3).find("length of numberOfCells is 11"), std::string::npos);
  mesh = good;
  mesh.walls[1].cells = { { 2, 2 } };
  EXPECT_EQ(RefusalOf(mesh, 3), "Wall mesh: the second cell of wall 1 is 2, must be another than the first");
}
