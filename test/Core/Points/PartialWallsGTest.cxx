/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/PartialWalls.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace tissue;

namespace
{
/** Four cells in the quarters of a plate of four planes, where 1 and 4 meet by an edge of voxels in the middle: in the
 * lowest plane 2 and 3 meet in their place. */
std::vector<std::int32_t>
MakeQuarters(const TissueGrid & grid)
{
  std::vector<std::int32_t> labels(grid.NumberOfPoints(), 0);
  for (std::int32_t z = 1; z < 5; ++z)
  {
    for (std::int32_t y = 0; y < 8; ++y)
    {
      for (std::int32_t x = 0; x < 8; ++x)
      {
        labels[grid.Offset(x, y, z)] = 1 + (x < 4 ? 0 : 1) + (y < 4 ? 0 : 2);
      }
    }
    labels[z == 1 ? grid.Offset(3, 3, z) : grid.Offset(4, 3, z)] = z == 1 ? 2 : 1;
  }
  return labels;
}

std::size_t
CountFaces(const std::vector<std::int32_t> & labels, const TissueGrid & grid, std::int32_t a, std::int32_t b)
{
  std::size_t faces = 0;
  for (std::int32_t z = 0; z < grid.size[2]; ++z)
  {
    for (std::int32_t y = 0; y + 1 < grid.size[1]; ++y)
    {
      for (std::int32_t x = 0; x + 1 < grid.size[0]; ++x)
      {
        for (const std::size_t next : { grid.Offset(x + 1, y, z), grid.Offset(x, y + 1, z) })
        {
          faces += std::minmax(labels[grid.Offset(x, y, z)], labels[next]) == std::minmax(a, b) ? 1 : 0;
        }
      }
    }
  }
  return faces;
}
} // namespace

TEST(PartialWalls, GoWhereAnotherGoesAcross)
{
  const TissueGrid grid = MakeTissueGrid({ { { 0, 0, 0 } }, { { 8, 8, 6 } } }, 1.0);
  auto             labels = MakeQuarters(grid);
  ASSERT_EQ(CountFaces(labels, grid, 2, 3), 1u);
  ASSERT_EQ(CountFaces(labels, grid, 1, 4), 3u);
  const auto numberInside = std::count(labels.begin(), labels.end(), 0);
  RemovePartialWalls(labels, grid, 2.0);
  EXPECT_EQ(CountFaces(labels, grid, 2, 3), 0u);
  EXPECT_GE(CountFaces(labels, grid, 1, 4), 3u);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 0), numberInside);
}

TEST(PartialWalls, StayWithoutAThirdCellOrWithFacesEnough)
{
  const TissueGrid grid = MakeTissueGrid({ { { 0, 0, 0 } }, { { 8, 8, 6 } } }, 1.0);
  const auto       labels = MakeQuarters(grid);
  auto             same = labels;
  RemovePartialWalls(same, grid, 1.0);
  EXPECT_EQ(same, labels);
  std::vector<std::int32_t> two(grid.NumberOfPoints(), 0);
  two[grid.Offset(3, 3, 3)] = 1;
  two[grid.Offset(4, 3, 3)] = 2;
  same = two;
  RemovePartialWalls(same, grid, 5.0);
  EXPECT_EQ(same, two);
}
