/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/Cavities.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

using namespace tissue;

namespace
{
/** A block of 5 x 5 x 5 voxels: `core` in the middle, cell 1 around it, and cell 2 around that. */
WallMesh
NestedBlock(VertexId core)
{
  std::vector<VertexId> vertices;
  for (int i = 0; i < 125; ++i)
  {
    const auto isWithin = [i](int least, int most) {
      const int place[3] = { i % 5, i / 5 % 5, i / 25 };
      return std::all_of(place, place + 3, [=](int p) { return p >= least && p <= most; });
    };
    vertices.push_back(isWithin(2, 2) ? core : isWithin(1, 3) ? 1 : 2);
  }
  return MakeVoxelWallMesh({ { 5, 5, 5 } }, vertices);
}

std::vector<VertexId>
CellsOf(const std::vector<Cavity> & cavities)
{
  std::vector<VertexId> cells;
  std::transform(cavities.begin(), cavities.end(), std::back_inserter(cells), [](const Cavity & c) { return c.cell; });
  return cells;
}
} // namespace

TEST(Cavities, AreClosedWallsToTheExteriorWithin)
{
  const auto cavities = FindCavities(NestedBlock(ExteriorVertex));
  ASSERT_EQ(CellsOf(cavities), std::vector<VertexId>{ 1 });
  EXPECT_DOUBLE_EQ(cavities[0].volume, 1.0);
  EXPECT_EQ(cavities[0].box.lower, (Point{ { 2.0, 2.0, 2.0 } }));
  EXPECT_EQ(cavities[0].box.upper, (Point{ { 3.0, 3.0, 3.0 } }));
  EXPECT_EQ(cavities[0].walls.size(), 1u);
}

TEST(Cavities, AreNeitherOuterSurfacesNorCellsWithinCells)
{
  // The wall of cell 2 and the exterior is closed, too.
  EXPECT_TRUE(FindCavities(NestedBlock(3)).empty());
  EXPECT_TRUE(FindCavities(NestedBlock(1)).empty());
}

TEST(Cavities, AreNoWallsWithARim)
{
  // The exterior within two cells: none of the two walls is closed.
  const auto mesh = MakeVoxelWallMesh({ { 4, 3, 3 } }, [] {
    std::vector<VertexId> vertices(36, 1);
    for (int i = 0; i < 36; ++i)
    {
      vertices[i] = i % 4 < 2 ? 1 : 2;
    }
    vertices[1 + 4 * (1 + 3)] = ExteriorVertex;
    return vertices;
  }());
  EXPECT_TRUE(FindCavities(mesh).empty());
}
