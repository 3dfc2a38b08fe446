/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Evaluation/SeparateWalls.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

#include <vector>

using namespace tissue;

namespace
{
/** A bar of cell 2 across the two legs of cell 1, of `width` times four voxels each. */
LabelVolume
MakeBridge(int width)
{
  LabelVolume volume;
  volume.size = { { 3 * width, 3, 4 } };
  for (int i = 0; i < 3 * width * 3 * 4; ++i)
  {
    const int  x = i % (3 * width);
    const int  y = i / (3 * width) % 3;
    const bool isGap = y == 1 && x / width == 1;
    volume.vertices.push_back(isGap ? ExteriorVertex : y == 2 ? 2 : 1);
  }
  return volume;
}

WallMesh
MeshOf(const LabelVolume & volume)
{
  return MakeVoxelWallMesh({ { volume.size[0], volume.size[1], volume.size[2] } },
                           { volume.vertices.begin(), volume.vertices.end() });
}

void
ExpectCounts(const SeparateWalls & walls, std::size_t pairs, std::size_t kept)
{
  EXPECT_EQ(walls.numberOfPairs, pairs);
  EXPECT_EQ(walls.numberOfKeptPairs, kept);
}
} // namespace

TEST(SeparateWalls, OfTwoCellsAreKeptByTheMeshOfTheirFaces)
{
  const LabelVolume bridge = MakeBridge(3);
  ExpectCounts(CountSeparateWalls(MeshOf(bridge), bridge), 1, 1);
}

TEST(SeparateWalls, OfFewFacesAreNoise)
{
  // Two walls of eight faces.
  const LabelVolume bridge = MakeBridge(2);
  ExpectCounts(CountSeparateWalls(MeshOf(bridge), bridge), 0, 0);
}

TEST(SeparateWalls, OneOfTwoIsNotEnough)
{
  const LabelVolume bridge = MakeBridge(3);
  WallMesh          mesh = MeshOf(bridge);
  for (std::size_t t = mesh.triangles.size(); t-- > 0;)
  {
    const auto & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    if (cells == VertexPair{ { 1, 2 } } && mesh.points[mesh.triangles[t][0]][0] <= 3.0)
    {
      mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      mesh.wallOfTriangle.erase(mesh.wallOfTriangle.begin() + static_cast<std::ptrdiff_t>(t));
    }
  }
  ExpectCounts(CountSeparateWalls(mesh, bridge), 1, 0);
  ExpectCounts(CountSeparateWalls(WallMesh(), bridge), 1, 0);
}

TEST(SeparateWalls, OfACellAreThoseToTheExteriorToo)
{
  // A shell of cell 1 around a hollow of 3 x 1 x 1 voxels, whose surface is of 14 faces.
  LabelVolume shell;
  shell.size = { { 5, 3, 3 } };
  shell.vertices = VoxelVertices(45, 1);
  shell.vertices.Fill(21, 24, ExteriorVertex);
  ExpectCounts(CountSeparateWalls(MeshOf(shell), shell), 1, 1);
  LabelVolume solid = shell;
  solid.vertices = VoxelVertices(45, 1);
  ExpectCounts(CountSeparateWalls(MeshOf(solid), shell), 1, 0);
  ExpectCounts(CountSeparateWalls(MeshOf(shell), solid), 0, 0);
}
