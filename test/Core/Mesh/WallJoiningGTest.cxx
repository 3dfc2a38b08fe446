/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallJoining.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

#include <set>

using namespace tissue_test;

namespace
{
/** Four cells, of which the fourth is a part of the third: walls between the two are gone. */
WallMesh
DividedCells()
{
  const WallMesh whole = FourCells();
  WallMesh       divided = whole;
  divided.triangles.clear();
  divided.wallOfTriangle.clear();
  divided.walls.clear();
  for (std::size_t t = 0; t < whole.triangles.size(); ++t)
  {
    VertexPair cells = whole.walls[whole.wallOfTriangle[t]].cells;
    std::replace(cells.begin(), cells.end(), 4, 3);
    if (cells[0] != cells[1])
    {
      const bool isNext = t == 0 || whole.wallOfTriangle[t] != whole.wallOfTriangle[t - 1] || divided.walls.empty();
      if (isNext)
      {
        divided.walls.push_back({ cells });
      }
      divided.triangles.push_back(whole.triangles[t]);
      divided.wallOfTriangle.push_back(static_cast<WallId>(divided.walls.size()) - 1);
    }
  }
  return divided;
}
} // namespace

TEST(WallJoining, WallsThatMeetAtASeamBecomeOne)
{
  WallMesh mesh = DividedCells();
  ASSERT_EQ(mesh.walls.size(), 9u);
  const std::size_t numberOfTriangles = mesh.triangles.size();
  JoinWalls(mesh);
  std::set<VertexPair> pairs;
  for (const WallMesh::Wall & wall : mesh.walls)
  {
    EXPECT_TRUE(pairs.insert(wall.cells).second);
  }
  EXPECT_EQ(pairs.size(), 6u) << "of three cells and the exterior";
  EXPECT_EQ(mesh.triangles.size(), numberOfTriangles);
  EXPECT_TRUE(std::is_sorted(mesh.wallOfTriangle.begin(), mesh.wallOfTriangle.end()));
}

TEST(WallJoining, CellsAtPointsAreCountedAnew)
{
  WallMesh mesh = DividedCells();
  JoinWalls(mesh);
  const CellSurfaceCheck check = CheckCellSurfaces(mesh, 4);
  EXPECT_EQ(check.numberOfMiscountedPoints, 0);
  EXPECT_TRUE(check.cellsThatAreNoSphere.empty());
}

TEST(WallJoining, LeavesATissueWithoutSeamsAsItIs)
{
  const WallMesh before = RandomTissue(20);
  WallMesh       mesh = before;
  JoinWalls(mesh);
  EXPECT_EQ(mesh.walls.size(), before.walls.size());
  EXPECT_EQ(mesh.triangles, before.triangles);
  EXPECT_EQ(mesh.wallOfTriangle, before.wallOfTriangle);
  EXPECT_EQ(mesh.numberOfCells, before.numberOfCells);
}
