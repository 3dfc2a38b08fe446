/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallPieces.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
std::vector<WallPiece>
CutOutWalls(const WallMesh & mesh)
{
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(mesh);
  std::vector<WallPiece>         pieces;
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    pieces.push_back(CutOutWall(mesh, first[w], first[w + 1]));
  }
  return pieces;
}
} // namespace

TEST(WallPieces, CutOutAndJoinedTheMeshIsTheSame)
{
  const WallMesh               mesh = RandomTissue(10);
  const std::vector<WallPiece> pieces = CutOutWalls(mesh);
  ASSERT_EQ(pieces.size(), mesh.walls.size());
  for (const WallPiece & piece : pieces)
  {
    EXPECT_EQ(piece.interior.size(), 1u);
    EXPECT_EQ(piece.triangles.size(), piece.outline.size());
  }
  const WallMesh joined = JoinWallPieces(mesh, pieces);
  EXPECT_EQ(joined.points, mesh.points);
  EXPECT_EQ(joined.numberOfCells, mesh.numberOfCells);
  EXPECT_EQ(joined.triangles, mesh.triangles);
  EXPECT_EQ(joined.wallOfTriangle, mesh.wallOfTriangle);
}

TEST(WallPieces, PointsOfLinesComeFirst)
{
  WallMesh mesh = RoundOrange(1);
  mesh = JoinWallPieces(mesh, CutOutWalls(mesh));
  ExpectSound(mesh, 3);
  EXPECT_TRUE(std::is_partitioned(
    mesh.numberOfCells.begin(), mesh.numberOfCells.end(), [](int cells) { return cells > CellsWithinWall; }));
}

TEST(WallPieces, RefusesWallsWhoseTrianglesAreScattered)
{
  WallMesh mesh = FourCells();
  std::swap(mesh.wallOfTriangle.front(), mesh.wallOfTriangle.back());
  EXPECT_THROW(FirstTrianglesOfWalls(mesh), std::invalid_argument);
}
