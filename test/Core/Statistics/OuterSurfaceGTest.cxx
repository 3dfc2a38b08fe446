/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Statistics/OuterSurface.h"

#include "FourCubes.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace tissue;

TEST(OuterSurface, HasTheExteriorWallsWithTheirNeighbors)
{
  const FourCubes           tissue;
  const std::vector<double> areas{ 0.0, 6.0, 6.0, 6.0, 6.0 };
  const OuterSurface        surface = FindOuterSurface(tissue.mesh, tissue.cells, areas, ImageGrid());
  ASSERT_EQ(surface.walls.size(), 4u);
  for (std::size_t w = 0; w < 4; ++w)
  {
    const OuterWall & wall = surface.walls[w];
    EXPECT_EQ(wall.cell, tissue.mesh.walls[wall.wall].cells[0]);
    EXPECT_DOUBLE_EQ(wall.area, 4.0);
    EXPECT_DOUBLE_EQ(wall.diameter, std::sqrt(6.0 / std::acos(-1.0)));
    EXPECT_FALSE(wall.isCut);
    // Top and bottom cancel out, of the sides two are left.
    const Point & center = tissue.cells[wall.cell].center;
    const Point   expected{ { center[0] < 1.0 ? -1.0 : 1.0, center[1] < 1.0 ? -1.0 : 1.0, 0.0 } };
    EXPECT_LT(Distance(wall.normal, expected), 1e-12);
    EXPECT_EQ(surface.samples[w].size(), 24u);
    // Those across the edge of the four cubes share no line.
    EXPECT_EQ(surface.neighbors[w].size(), 2u);
    for (const std::size_t neighbor : surface.neighbors[w])
    {
      EXPECT_NEAR(Distance(center, tissue.cells[surface.walls[neighbor].cell].center), 1.0, 1e-12);
    }
  }
}

TEST(OuterSurface, WithoutWhatTheBorderCuts)
{
  FourCubes tissue;
  for (Cell & cell : tissue.cells)
  {
    cell.touchesBorder = true;
  }
  // The image ends below the cubes, and far off elsewhere.
  ImageGrid grid;
  grid.size = { { 100, 100, 100 } };
  grid.steps = { { { { 0.1, 0, 0 } }, { { 0, 0.1, 0 } }, { { 0, 0, 0.1 } } } };
  grid.origin = { { -5, -5, 0.05 } };
  const OuterSurface surface = FindOuterSurface(tissue.mesh, tissue.cells, { 0.0, 6.0, 6.0, 6.0, 6.0 }, grid);
  ASSERT_EQ(surface.walls.size(), 4u);
  for (const OuterWall & wall : surface.walls)
  {
    EXPECT_DOUBLE_EQ(wall.area, 3.0);
    EXPECT_NEAR(wall.normal[2], 1.0, 1e-12);
    EXPECT_NEAR(surface.cutAreas[wall.wall], 1.0, 1e-12);
  }
}
