/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "FourCubes.h"
#include "Shared/Pictures/CellColors.h"

#include <gtest/gtest.h>

#include <cstdlib>

TEST(CellColors, NeighborsDifferByAGoodPartOfTheColorCube)
{
  const FourCubes tissue;
  const auto      colors = tissue::ChooseCellColors(tissue.mesh, 5);
  for (const auto & wall : tissue.mesh.walls)
  {
    if (wall.cells[1] != tissue::ExteriorVertex)
    {
      int difference = 0;
      for (int c = 0; c < 3; ++c)
      {
        difference += std::abs(colors[wall.cells[0]][c] - colors[wall.cells[1]][c]);
      }
      EXPECT_GT(difference, 60);
    }
  }
}

TEST(CellColors, ManyCellsThatDoNotTouchTakeManyColors)
{
  const auto                       mesh = MakeVoxelWallMesh({ { 5, 1, 1 } }, { 1, 0, 2, 0, 3 });
  const std::vector<tissue::Color> colors = tissue::ChooseCellColors(mesh, 4);
  EXPECT_NE(colors[1], colors[2]);
  EXPECT_NE(colors[1], colors[3]);
  EXPECT_NE(colors[2], colors[3]);
}
