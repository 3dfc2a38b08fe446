/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "VoxelDice.h"
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
  volume.vertices.assign(12 * 8 * 8, 0);
  volume.origin = { { 7.0, -2.0, 3.0 } };
  volume.steps = { { { { 0.0, 0.5, 0.0 } }, { { -0.5, 0.0, 0.0 } }, { { 0.0, 0.0, 2.0 } } } };
  for (int z = 2; z < 6; ++z)
  {
    for (int y = 2; y < 6; ++y)
    {
      for (int x = 2; x < 10; ++x)
      {
        volume.vertices[(z * 8 + y) * 12 + x] = x < 6 ? 1 : 2;
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
