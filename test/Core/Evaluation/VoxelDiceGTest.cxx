/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Evaluation/VoxelDice.h"
#include "TestWallMeshes.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
/** Two blocks of 4 x 4 x 4 voxels side by side along x, in a margin of two voxels; turned by a right angle,
 * anisotropic. */
LabelVolume
MakeVolume()
{
  LabelVolume volume;
  volume.size = { { 12, 8, 8 } };
  volume.vertices = VoxelVertices(12 * 8 * 8, 0);
  volume.origin = { { 7.0, -2.0, 3.0 } };
  volume.steps = { { { { 0.0, 0.5, 0.0 } }, { { -0.5, 0.0, 0.0 } }, { { 0.0, 0.0, 2.0 } } } };
  for (int z = 2; z < 6; ++z)
  {
    for (int y = 2; y < 6; ++y)
    {
      for (int x = 2; x < 10; ++x)
      {
        volume.vertices.Put((z * 8 + y) * 12 + x, x < 6 ? 1 : 2);
      }
    }
  }
  return volume;
}

/** The blocks as a mesh, with another edge along x for the first one, in physical space. */
WallMesh
MakeBlocks(const LabelVolume & grid, double wallAt)
{
  WallMesh mesh = MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
  for (Point & p : mesh.points)
  {
    const double x = p[0] == 0.0 ? 1.5 : p[0] == 1.0 ? wallAt : 9.5;
    p = grid.ToPhysical({ { x, 1.5 + 4.0 * p[1], 1.5 + 4.0 * p[2] } });
  }
  return mesh;
}
} // namespace

TEST(VoxelDice, IsOneForTheVoxelsThemselvesAndLessForAMovedWall)
{
  const LabelVolume labels = MakeVolume();
  const auto        same = ComputeVoxelDice(MakeBlocks(labels, 5.5), 3, labels);
  EXPECT_DOUBLE_EQ(same[1], 1.0);
  EXPECT_DOUBLE_EQ(same[2], 1.0);
  // Two of four layers: 2 * 32 / (32 + 64), and 2 * 64 / (96 + 64) for the cell that has them.
  const auto moved = ComputeVoxelDice(MakeBlocks(labels, 3.5), 3, labels);
  EXPECT_NEAR(moved[1], 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(moved[2], 0.8, 1e-12);
  EXPECT_EQ(ComputeVoxelDice(WallMesh(), 3, labels)[1], 0.0) << "without a triangle";
}

TEST(VoxelDice, GivesACentreOnAWallToOneOfItsCells)
{
  // All sides, and so the diagonals of their squares, go through centres of voxels.
  LabelVolume labels;
  labels.size = { { 8, 5, 5 } };
  labels.vertices = VoxelVertices(8 * 5 * 5, 1);
  WallMesh mesh = MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
  for (Point & p : mesh.points)
  {
    p = { { 3.0 * p[0], 4.0 * p[1], 4.0 * p[2] } };
  }
  const auto   dice = ComputeVoxelDice(mesh, 3, labels);
  const double within = 3 * 4 * 4; // of each of the two
  EXPECT_DOUBLE_EQ(dice[1], 2.0 * within / (within + 200.0));
  EXPECT_EQ(dice[2], 0.0) << "has no voxel in the image";
}

TEST(VoxelDice, CountsNoVoxelOutsideOfTheImage)
{
  LabelVolume labels;
  labels.size = { { 2, 2, 2 } };
  labels.vertices = VoxelVertices(8, 1);
  WallMesh mesh = MakeVoxelWallMesh({ { 1, 1, 1 } }, { 1 });
  for (Point & p : mesh.points)
  {
    p = 1e30 * (p - Point{ { 0.5, 0.5, 0.5 } });
  }
  EXPECT_DOUBLE_EQ(ComputeVoxelDice(mesh, 2, labels)[1], 1.0);
}

TEST(VoxelDice, OfABallIsThatOfItsVoxels)
{
  // A ball of many triangles against the voxels that are within its radius: all but a few at its surface.
  LabelVolume labels;
  labels.size = { { 41, 41, 41 } };
  const double radius = 17.3;
  for (int i = 0; i < 41 * 41 * 41; ++i)
  {
    const Point p{ { i % 41 - 20.0, i / 41 % 41 - 20.0, i / (41 * 41) - 20.0 } };
    labels.vertices.push_back(Norm(p) < radius ? 1 : 0);
  }
  WallMesh mesh = tissue_test::RoundOrange(5);
  for (Point & p : mesh.points)
  {
    p = radius * p + Point{ { 20.0, 20.0, 20.0 } };
  }
  // Of the three slices one cell.
  WallMesh ball;
  ball.points = mesh.points;
  ball.walls = { { { { 1, 0 } } } };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (mesh.walls[mesh.wallOfTriangle[t]].cells[1] == ExteriorVertex)
    {
      ball.triangles.push_back(mesh.triangles[t]);
      ball.wallOfTriangle.push_back(0);
    }
  }
  EXPECT_GT(ComputeVoxelDice(ball, 2, labels)[1], 0.998);
}
