/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Evaluation/WallDistance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace tissue;

namespace
{
/** 4 x 2 x 2 voxels, the two cells side by side along x: their wall is 2 x 2 faces at x = 1.5. */
struct TwoCells
{
  /** The wall as a square of two triangles, displaced along x; in physical space. */
  WallMesh
  MakeWall(const LabelVolume & grid, double displacement) const
  {
    WallMesh mesh;
    for (const auto & [y, z] :
         { std::array<double, 2>{ { -0.5, -0.5 } }, { { 1.5, -0.5 } }, { { 1.5, 1.5 } }, { { -0.5, 1.5 } } })
    {
      mesh.points.push_back(grid.ToPhysical({ { 1.5 + displacement, y, z } }));
    }
    mesh.triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
    mesh.wallOfTriangle = { 0, 0 };
    mesh.walls = { { { { 1, 2 } } } };
    return mesh;
  }
};

LabelVolume
MakeVolume(double spacing)
{
  LabelVolume volume;
  volume.size = { { 4, 2, 2 } };
  volume.vertices = { 1, 1, 2, 2, 1, 1, 2, 2, 1, 1, 2, 2, 1, 1, 2, 2 };
  volume.origin = { { 5.0, -3.0, 1.0 } };
  volume.steps = { { { { spacing, 0.0, 0.0 } }, { { 0.0, spacing, 0.0 } }, { { 0.0, 0.0, spacing } } } };
  return volume;
}
} // namespace

TEST(WallDistance, IsThatOfCentroidsToFaceCentres)
{
  // A centroid is a sixth of a voxel along y and z from the next centre of a face.
  const TwoCells two;
  for (const double spacing : { 1.0, 0.25 })
  {
    const LabelVolume  labels = MakeVolume(spacing);
    const WallDistance on = MeasureWallDistance(two.MakeWall(labels, 0.0), 3, labels);
    EXPECT_NEAR(on.InVoxels(on.mean), std::sqrt(2.0) / 6.0, 1e-6);
    EXPECT_NEAR(on.mean, spacing * on.InVoxels(on.mean), 1e-6);
    EXPECT_NEAR(on.ofVertex[1], on.mean, 1e-6);
    EXPECT_NEAR(on.ofVertex[2], on.mean, 1e-6);
    EXPECT_EQ(on.shareOfFalseWalls, 0.0);
    const WallDistance off = MeasureWallDistance(two.MakeWall(labels, 2.0), 3, labels);
    EXPECT_NEAR(off.InVoxels(off.mean), std::sqrt(4.0 + 2.0 / 36.0), 1e-6);
  }
}

TEST(WallDistance, WallThatTheImageHasNotIsCountedByItsArea)
{
  const TwoCells two;
  LabelVolume    labels = MakeVolume(1.0);
  labels.vertices.Fill(0, labels.vertices.size(), 1); // cell 2 is gone
  const WallDistance distance = MeasureWallDistance(two.MakeWall(labels, 0.0), 3, labels);
  EXPECT_EQ(distance.shareOfFalseWalls, 1.0);
  EXPECT_EQ(distance.mean, -1.0);
  EXPECT_EQ(distance.InVoxels(distance.mean), -1.0);
  EXPECT_EQ(distance.ofVertex[1], -1.0);
}

TEST(WallDistance, IsThatToTheNearestOfManyFaces)
{
  // A step of 40 x 40 faces, at x = 9.5 and beyond y = 20 at x = 14.5, and triangles anywhere about it.
  LabelVolume labels;
  labels.size = { { 25, 40, 40 } };
  std::vector<Point> faces;
  for (int z = 0; z < 40; ++z)
  {
    for (int y = 0; y < 40; ++y)
    {
      const int last = y < 20 ? 9 : 14;
      faces.push_back({ { last + 0.5, 1.0 * y, 1.0 * z } });
      for (int x = 0; x < 25; ++x)
      {
        labels.vertices.push_back(x <= last ? 1 : 2);
      }
    }
  }
  for (int x = 10; x < 15; ++x)
  {
    for (int z = 0; z < 40; ++z)
    {
      faces.push_back({ { 1.0 * x, 19.5, 1.0 * z } });
    }
  }
  Random random(1);
  for (int i = 0; i < 100; ++i)
  {
    const Point at{ { 30.0 * random.Uniform() - 2.0, 44.0 * random.Uniform() - 2.0, 44.0 * random.Uniform() - 2.0 } };
    WallMesh    mesh;
    mesh.points = { at + Point{ { -1, -1, 0 } }, at + Point{ { 2, 0, 0 } }, at + Point{ { -1, 1, 0 } } };
    mesh.triangles = { { { 0, 1, 2 } } };
    mesh.wallOfTriangle = { 0 };
    mesh.walls = { { { { 1, 2 } } } };
    double nearest = 1e9;
    for (const Point & face : faces)
    {
      nearest = std::min(nearest, Distance(face, at));
    }
    EXPECT_NEAR(MeasureWallDistance(mesh, 3, labels).mean, nearest, 1e-9);
  }
}

TEST(WallDistance, FromTheImageIsThatOfFaceCentresToTriangles)
{
  const TwoCells     two;
  const LabelVolume  labels = MakeVolume(0.5);
  const WallDistance on = MeasureWallDistance(two.MakeWall(labels, 0.0), 3, labels);
  EXPECT_NEAR(on.meanFromImage, 0.0, 1e-6);
  EXPECT_NEAR(on.percentile95, on.mean, 1e-6) << "all centroids are as far";
  // The mesh has the 4 faces between the two cells, not the 40 at the exterior.
  EXPECT_NEAR(on.shareOfMissingWalls, 40.0 / 44.0, 1e-12);
  const WallDistance off = MeasureWallDistance(two.MakeWall(labels, 3.0), 3, labels);
  EXPECT_NEAR(off.meanFromImage, 1.5, 1e-6);
  EXPECT_NEAR(off.InVoxels(off.meanFromImage), 3.0, 1e-6);
  EXPECT_NEAR(off.percentile95, off.mean, 1e-6) << "the way from the mesh is the longer one";
}

TEST(WallDistance, OfATwentiethFartherOffIsTheHausdorffDistance)
{
  // One of the two triangles is cut off by half: faces beyond it are the farther ones.
  const TwoCells    two;
  const LabelVolume labels = MakeVolume(1.0);
  WallMesh          half = two.MakeWall(labels, 0.0);
  half.triangles.pop_back();
  half.wallOfTriangle.pop_back();
  const WallDistance distance = MeasureWallDistance(half, 3, labels);
  EXPECT_NEAR(distance.percentile95, std::sqrt(0.5), 1e-6) << "of the corner opposite to the triangle";
  EXPECT_NEAR(distance.meanFromImage, 0.25 * std::sqrt(0.5), 1e-6);
}

TEST(WallDistance, FromTheImageIsMinusOneWithoutItsWalls)
{
  const TwoCells two;
  LabelVolume    labels = MakeVolume(1.0);
  labels.vertices.Fill(0, labels.vertices.size(), 1);
  const WallDistance distance = MeasureWallDistance(two.MakeWall(labels, 0.0), 3, labels);
  EXPECT_EQ(distance.meanFromImage, -1.0);
  EXPECT_EQ(distance.percentile95, -1.0);
  EXPECT_EQ(distance.shareOfMissingWalls, 1.0);
}
