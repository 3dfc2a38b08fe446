/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/WallRefinement.h"
#include "TestWallMeshes.h"
#include "WallMeshChecks.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace tissue_test;

namespace
{
/** An octahedron around cell 1, split and put on the unit sphere: no junctions, no triple lines. */
WallMesh
Sphere(int numberOfSplits)
{
  WallMesh mesh;
  mesh.points = { { { 1, 0, 0 } },  { { 0, 1, 0 } },  { { 0, 0, 1 } },
                  { { -1, 0, 0 } }, { { 0, -1, 0 } }, { { 0, 0, -1 } } };
  mesh.numberOfCells.assign(6, CellsWithinWall);
  mesh.triangles = { { { 0, 1, 2 } }, { { 1, 3, 2 } }, { { 3, 4, 2 } }, { { 4, 0, 2 } },
                     { { 1, 0, 5 } }, { { 3, 1, 5 } }, { { 4, 3, 5 } }, { { 0, 4, 5 } } };
  mesh.wallOfTriangle.assign(8, 0);
  mesh.walls.push_back({ { { 1, ExteriorVertex } } });
  for (int i = 0; i < numberOfSplits; ++i)
  {
    SplitTriangles(mesh);
  }
  for (Point & p : mesh.points)
  {
    p = Normalized(p);
  }
  return mesh;
}

/** Root mean square of the distances from the unit sphere. */
double
Roughness(const WallMesh & mesh)
{
  double sum = 0.0;
  for (const Point & p : mesh.points)
  {
    sum += (Norm(p) - 1.0) * (Norm(p) - 1.0);
  }
  return std::sqrt(sum / static_cast<double>(mesh.points.size()));
}
} // namespace

TEST(WallRefinement, SplitMakesFourOfEachTriangleAndAPointOfEachEdge)
{
  WallMesh          mesh = RandomTissue(20);
  const WallMesh    before = mesh;
  const std::size_t corners =
    static_cast<std::size_t>(std::count(mesh.numberOfCells.begin(), mesh.numberOfCells.end(), CellsAtCorner));
  SplitTriangles(mesh);
  EXPECT_EQ(mesh.triangles.size(), 4 * before.triangles.size());
  // Every star triangle has one edge on a dual edge, of which there are two for each tetrahedron; the other edges join
  // the walls' centres to their corners, one for each triangle.
  EXPECT_EQ(mesh.points.size(), before.points.size() + 2 * corners + before.triangles.size());
  EXPECT_EQ(std::count(mesh.numberOfCells.begin(), mesh.numberOfCells.end(), CellsOnLine),
            static_cast<std::ptrdiff_t>(2 * corners));
  EXPECT_TRUE(std::equal(before.points.begin(), before.points.end(), mesh.points.begin())) << "old points stay";
  ExpectInvariants(mesh, 21);
}

TEST(WallRefinement, SplitTwiceKeepsTheInvariantsTheVolumesAndTheArea)
{
  WallMesh       mesh = RandomTissue(20);
  const WallMesh before = mesh;
  SplitTriangles(mesh);
  SplitTriangles(mesh);
  EXPECT_EQ(mesh.triangles.size(), 16 * before.triangles.size());
  ExpectInvariants(mesh, 21);
  for (VertexId cell = 0; cell <= 20; ++cell)
  {
    EXPECT_NEAR(VolumeOf(mesh, cell), VolumeOf(before, cell), 1e-12);
  }
}

TEST(WallRefinement, SmoothingKeepsJunctionsAndTheMesh)
{
  WallMesh mesh = RandomTissue(20);
  SplitTriangles(mesh);
  SplitTriangles(mesh);
  const WallMesh before = mesh;
  SmoothWalls(mesh, 10);
  EXPECT_EQ(mesh.triangles, before.triangles);
  std::size_t moved = 0;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (mesh.numberOfCells[p] == CellsAtCorner)
    {
      EXPECT_EQ(mesh.points[p], before.points[p]);
    }
    moved += mesh.points[p] != before.points[p] ? 1 : 0;
  }
  EXPECT_GT(moved, mesh.points.size() / 2);
  ExpectInvariants(mesh, 21);
}

TEST(WallRefinement, SmoothingKeepsStraightTripleLinesStraight)
{
  // Points of a triple line follow the line alone, whatever the walls around it do: after a split it is straight.
  WallMesh mesh = RandomTissue(20);
  SplitTriangles(mesh);
  const WallMesh before = mesh;
  SmoothWalls(mesh, 10);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (mesh.numberOfCells[p] == CellsOnLine)
    {
      EXPECT_NEAR(Distance(mesh.points[p], before.points[p]), 0.0, 1e-12);
    }
  }
}

TEST(WallRefinement, NoIterationChangesNothing)
{
  WallMesh       mesh = RandomTissue(10);
  const WallMesh before = mesh;
  SmoothWalls(mesh, 0);
  EXPECT_EQ(mesh.points, before.points);
}

TEST(WallRefinement, SmoothingDoesNotShrinkASphere)
{
  WallMesh     mesh = Sphere(3);
  const double volume = VolumeOf(mesh, 1);
  const int    iterations = 50;
  SmoothWalls(mesh, iterations);
  // An iteration multiplies a wave of frequency k by (1 - 0.5 k)(1 + 0.53 k), at most 1 + 0.03^2 / (4 * 0.265).
  const double largest = std::pow(1.0 + 0.03 * 0.03 / (4 * 0.265), 3 * iterations);
  EXPECT_GT(VolumeOf(mesh, 1) / volume, 0.99);
  EXPECT_LT(VolumeOf(mesh, 1) / volume, largest);
}

TEST(WallRefinement, SmoothingTakesNoiseFromASphere)
{
  WallMesh mesh = Sphere(3);
  Random   random(1);
  for (Point & p : mesh.points)
  {
    p = (1.0 + 0.1 * (random.Uniform() - 0.5)) * p;
  }
  const double before = Roughness(mesh);
  SmoothWalls(mesh, 10);
  EXPECT_LT(Roughness(mesh), 0.5 * before);
}
