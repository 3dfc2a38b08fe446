/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Simulation/CellSolids.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
/** A block of 7 x 7 x 7 voxels of cell 1 in which voxels are of other vertices. */
CellSolids
SolidsOfBlock(const std::vector<std::pair<std::array<int, 3>, VertexId>> & others, std::size_t numberOfVertices)
{
  std::vector<VertexId> vertices(343, 1);
  for (const auto & [voxel, vertex] : others)
  {
    vertices[static_cast<std::size_t>(voxel[0] + 7 * (voxel[1] + 7 * voxel[2]))] = vertex;
  }
  return FindCellSolids(MakeVoxelWallMesh({ { 7, 7, 7 } }, vertices), numberOfVertices);
}
} // namespace

TEST(CellSolids, ACellIsBoundByItsWalls)
{
  const CellSolids found = FindCellSolids(MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 }), 3);
  ASSERT_EQ(found.solids.size(), 2u);
  EXPECT_TRUE(found.openCells.empty());
  for (int c = 0; c < 2; ++c)
  {
    const CellSolid & solid = found.solids[static_cast<std::size_t>(c)];
    EXPECT_EQ(solid.cell, c + 1);
    EXPECT_DOUBLE_EQ(solid.volume, 1.0);
    ASSERT_EQ(solid.surfaces.size(), 1u);
    // Walls are sorted: (1, exterior), (1, 2), (2, exterior).
    EXPECT_EQ(solid.surfaces[0], (c == 0 ? std::vector<WallId>{ 0, 1 } : std::vector<WallId>{ 1, 2 }));
    EXPECT_TRUE(solid.inside[0] > c && solid.inside[0] < c + 1);
    EXPECT_TRUE(solid.inside[1] > 0.0 && solid.inside[1] < 1.0);
    EXPECT_TRUE(solid.inside[2] > 0.0 && solid.inside[2] < 1.0);
  }
}

TEST(CellSolids, VoidsAndCellsWithinBoundTheirCellAndAreVolumesOfTheirOwn)
{
  const CellSolids found = SolidsOfBlock({ { { { 3, 3, 3 } }, ExteriorVertex }, { { { 5, 5, 5 } }, 2 } }, 3);
  ASSERT_EQ(found.solids.size(), 3u);
  EXPECT_EQ(found.solids[0].cell, 1);
  EXPECT_EQ(found.solids[0].surfaces.size(), 3u);
  EXPECT_NEAR(found.solids[0].volume, 341.0, 1e-9);
  EXPECT_EQ(found.solids[1].cell, 2);
  EXPECT_EQ(found.solids[2].cell, ExteriorVertex);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_GT(found.solids[1].inside[axis], 5.0);
    EXPECT_LT(found.solids[1].inside[axis], 6.0);
    EXPECT_GT(found.solids[2].inside[axis], 3.0);
    EXPECT_LT(found.solids[2].inside[axis], 4.0);
  }
}

TEST(CellSolids, PiecesOfACellAreSolidsEach)
{
  const CellSolids found = FindCellSolids(MakeVoxelWallMesh({ { 3, 1, 1 } }, { 1, 2, 1 }), 3);
  ASSERT_EQ(found.solids.size(), 3u);
  EXPECT_EQ(found.solids[0].cell, 1);
  EXPECT_EQ(found.solids[1].cell, 1);
  EXPECT_EQ(found.solids[2].cell, 2);
}

TEST(CellSolids, ThePointWithinIsNotInWhatIsAcross)
{
  // The largest sides of a plate one voxel thick look at each other through a void.
  std::vector<std::pair<std::array<int, 3>, VertexId>> hollow;
  for (int i = 0; i < 125; ++i)
  {
    hollow.push_back({ { { 1 + i % 5, 1 + i / 5 % 5, 1 + i / 25 } }, ExteriorVertex });
  }
  const CellSolids found = SolidsOfBlock(hollow, 2);
  ASSERT_EQ(found.solids.size(), 2u);
  const Point & p = found.solids[0].inside;
  EXPECT_FALSE(p[0] > 1.0 && p[0] < 6.0 && p[1] > 1.0 && p[1] < 6.0 && p[2] > 1.0 && p[2] < 6.0);
}

TEST(CellSolids, OpenCellsHaveNone)
{
  WallMesh mesh = MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
  // The last triangle is one of cell 2 and the exterior.
  mesh.triangles.pop_back();
  mesh.wallOfTriangle.pop_back();
  const CellSolids found = FindCellSolids(mesh, 3);
  ASSERT_EQ(found.solids.size(), 1u);
  EXPECT_EQ(found.solids[0].cell, 1);
  EXPECT_EQ(found.openCells, std::vector<VertexId>{ 2 });
}
