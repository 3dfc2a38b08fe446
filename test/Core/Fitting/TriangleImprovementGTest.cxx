/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/TriangleImprovement.h"
#include "Mesh/WallLines.h"
#include "Remeshing/LineSubdivision.h"
#include "Remeshing/WallRemeshing.h"
#include "TestWallMeshes.h"
#include "TissueTessellationCore/Geometry/TriangleQuality.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
double
TotalDistortion(const WallMesh & mesh)
{
  double sum = 0.0;
  for (const auto & t : mesh.triangles)
  {
    sum += TriangleDistortion(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  }
  return sum;
}

Point
NormalOf(const WallMesh & mesh, std::size_t triangle)
{
  const auto & t = mesh.triangles[triangle];
  return Normalized(Cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]));
}
} // namespace

TEST(TriangleImprovement, FallsFromSweepToSweepAndKeepsCorners)
{
  WallMesh mesh = RandomTissue(20);
  RemeshToNumberOfTriangles(mesh, 20 * 150.0);
  const WallMesh before = mesh;
  for (int sweep = 0; sweep < 5; ++sweep)
  {
    const double distortion = TotalDistortion(mesh);
    ImproveTriangles(mesh, 1);
    EXPECT_LT(TotalDistortion(mesh), distortion);
  }
  EXPECT_EQ(mesh.triangles, before.triangles);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (mesh.numberOfCells[p] == CellsAtCorner)
    {
      EXPECT_EQ(mesh.points[p], before.points[p]);
    }
  }
}

TEST(TriangleImprovement, FlatWallsAndStraightLinesStaySo)
{
  WallMesh mesh = FourCells();
  SubdivideLines(mesh, std::vector<double>(mesh.walls.size(), 0.3));
  const WallMesh before = mesh;
  ImproveTriangles(mesh, 20);
  EXPECT_LT(TotalDistortion(mesh), 0.99 * TotalDistortion(before));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    EXPECT_NEAR(Dot(NormalOf(mesh, t), NormalOf(before, t)), 1.0, 1e-9) << "turned over or tilted";
  }
  for (const WallLine & line : CollectWallLines(mesh))
  {
    const double chord = Distance(mesh.points[line.points.front()], mesh.points[line.points.back()]);
    EXPECT_NEAR(LengthOf(line, mesh.points), chord, 1e-9);
  }
}

TEST(TriangleImprovement, TheOrderOfWorkDoesNotMatter)
{
  WallMesh forwards = RandomTissue(20);
  RemeshToNumberOfTriangles(forwards, 20 * 100.0);
  WallMesh backwards = forwards;
  ImproveTriangles(forwards, 3);
  ImproveTriangles(backwards, 3, Execution(RunBackwards));
  EXPECT_EQ(forwards.points, backwards.points);
}

TEST(TriangleImprovement, PointsThatWereMovedAsideGoBack)
{
  WallMesh mesh = FourCells();
  RemeshToNumberOfTriangles(mesh, 4 * 150.0);
  const QualitySummary good = SummarizeTriangleQuality(mesh.points, mesh.triangles);
  std::set<PointId>    moved;
  for (const auto & triangle : mesh.triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const PointId p = triangle[i];
      if (mesh.numberOfCells[p] == CellsWithinWall && moved.insert(p).second)
      {
        mesh.points[p] = mesh.points[p] + 0.3 * (mesh.points[triangle[(i + 1) % 3]] - mesh.points[p]);
      }
    }
  }
  const QualitySummary aside = SummarizeTriangleQuality(mesh.points, mesh.triangles);
  ASSERT_LT(aside.mean, good.mean - 0.02);
  ImproveTriangles(mesh, 20);
  EXPECT_GT(SummarizeTriangleQuality(mesh.points, mesh.triangles).mean, good.mean - 0.01);
  EXPECT_GT(SummarizeTriangleQuality(mesh.points, mesh.triangles).fifthPercentile, good.fifthPercentile - 0.02);
}

TEST(TriangleImprovement, APointAmongEquilateralTrianglesGoesToTheMiddle)
{
  WallMesh     mesh;
  const double sixth = std::acos(-1.0) / 3.0;
  for (int i = 0; i < 6; ++i)
  {
    mesh.points.push_back({ { std::cos(i * sixth), std::sin(i * sixth), 0.0 } });
    mesh.triangles.push_back({ { 6, i, (i + 1) % 6 } });
  }
  mesh.numberOfCells.assign(6, CellsAtCorner);
  mesh.wallOfTriangle.assign(6, 0);
  mesh.walls.push_back({ { { 1, 2 } } });
  mesh.points.push_back({ { 0.3, 0.2, 0.0 } });
  mesh.numberOfCells.push_back(CellsWithinWall);
  ImproveTriangles(mesh, 100);
  EXPECT_LT(Norm(mesh.points[6]), 1.0 / 64.0) << "within the shortest step";
}
