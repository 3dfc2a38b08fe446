/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/DualMesh.h"
#include "Fitting/WallProjection.h"
#include "FourCellBall.h"
#include "Image/IndicatorField.h"
#include "Remeshing/WallRefinement.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
const std::vector<VertexId> Whole{ 0, 1, 2, 3, 4 };

/** The walls with points moved at random by less than a voxel, but for the corners. */
WallMesh
ShakenWalls(const std::vector<Point> & corners)
{
  WallMesh mesh = TriangulateAsStars(Dualize(MakeComplex(), corners));
  SplitTriangles(mesh);
  SplitTriangles(mesh);
  Random random(3);
  for (std::size_t p = corners.size(); p < mesh.points.size(); ++p)
  {
    for (double & x : mesh.points[p])
    {
      x += VoxelLength * (random.Uniform() - 0.5);
    }
  }
  return mesh;
}

void
Project(WallMesh & mesh, const std::vector<Point> & corners, int times)
{
  const LabelVolume    volume = MakeVolume();
  const IndicatorField field(volume);
  const ImagePlaces    faces = CollectImageFaces(volume, CellsOfWalls(mesh));
  const auto           pairs = CellsOfWalls(mesh);
  const WallProjection projection(
    mesh, { volume, Whole, pairs }, field, faces, std::vector<double>(mesh.walls.size(), 5.0 * VoxelLength), corners);
  for (int i = 0; i < times; ++i)
  {
    projection.Move(mesh);
  }
}
} // namespace

TEST(WallProjection, PointsComeToTheirWalls)
{
  const std::vector<Point> corners = TrueCorners();
  const std::vector<Point> centers = RegularTetrahedron();
  WallMesh                 mesh = ShakenWalls(corners);
  Project(mesh, corners, 3);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    for (const PointId p : mesh.triangles[t])
    {
      if (mesh.numberOfCells[p] == CellsAtCorner)
      {
        continue;
      }
      const Point & point = mesh.points[p];
      if (cells[1] == ExteriorVertex)
      {
        // The sphere of this many voxels is itself uneven; lines are rounded off.
        EXPECT_NEAR(Norm(point), Radius, 0.75 * VoxelLength);
      }
      else
      {
        EXPECT_LT(std::abs(Dot(point, Normalized(centers[cells[0]] - centers[cells[1]]))), 0.4 * VoxelLength);
      }
    }
  }
}

TEST(WallProjection, CornersGoHalfwayToTheirPlaces)
{
  const std::vector<Point> corners = TrueCorners();
  std::vector<Point>       aside = corners;
  for (Point & corner : aside)
  {
    corner[0] += 0.4 * VoxelLength;
  }
  WallMesh mesh = ShakenWalls(aside);
  Project(mesh, corners, 1);
  for (std::size_t p = 0; p < corners.size(); ++p)
  {
    EXPECT_NEAR(Distance(mesh.points[p], corners[p]), 0.2 * VoxelLength, 1e-9);
  }
}

TEST(WallProjection, WallsThatTheImageHasNotStay)
{
  const std::vector<Point> corners = TrueCorners();
  const WallMesh           before = ShakenWalls(corners);
  WallMesh                 mesh = before;
  LabelVolume              volume = MakeVolume();
  volume.vertices.Fill(0, volume.vertices.size(), 1);
  const IndicatorField field(volume);
  const ImagePlaces    faces = CollectImageFaces(volume, CellsOfWalls(mesh));
  const auto           pairs = CellsOfWalls(mesh);
  const WallProjection projection(
    mesh, { volume, Whole, pairs }, field, faces, std::vector<double>(mesh.walls.size(), VoxelLength), corners);
  projection.Move(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    for (const PointId p : mesh.triangles[t])
    {
      if (cells[1] != ExteriorVertex && mesh.numberOfCells[p] == CellsWithinWall)
      {
        EXPECT_EQ(mesh.points[p], before.points[p]);
      }
    }
  }
}
