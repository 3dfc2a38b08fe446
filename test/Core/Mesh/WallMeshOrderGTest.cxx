/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallMeshOrder.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

using namespace tissue_test;

TEST(WallMeshOrder, PointsAreNumberedByTheFirstTriangleThatHasThem)
{
  WallMesh mesh = RandomTissue(20);
  TakePoints(mesh, PointsByTriangles(mesh));
  ExpectSound(mesh, 20);
  const auto numberOnLines = static_cast<PointId>(std::count_if(
    mesh.numberOfCells.begin(), mesh.numberOfCells.end(), [](int cells) { return cells > CellsWithinWall; }));
  PointId    nextOnLines = 0;
  PointId    nextWithin = numberOnLines;
  for (const auto & triangle : mesh.triangles)
  {
    for (const PointId p : triangle)
    {
      PointId & next = mesh.numberOfCells[p] == CellsWithinWall ? nextWithin : nextOnLines;
      EXPECT_LE(p, next);
      next = std::max(next, p + 1);
    }
  }
  EXPECT_EQ(nextOnLines, numberOnLines);
  EXPECT_EQ(nextWithin, static_cast<PointId>(mesh.points.size()));
}
