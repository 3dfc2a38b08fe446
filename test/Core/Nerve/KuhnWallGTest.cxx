/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/KuhnWall.h"

#include "Nerve/TestImages.h"
#include "Nerve/TissuePlaces.h"

#include <gtest/gtest.h>

using namespace testing_nerve;

namespace
{
/** The wall of two cells that have one; the lesser cell is its first. */
KuhnWall
WallOf(const LabelVolume & volume, VertexPair cells)
{
  for (const ImageWall & wall : FindImageWalls(volume))
  {
    if (wall.cells == cells)
    {
      const auto & f = wall.face[0];
      const bool   isFirst = volume.At(f[0], f[1], f[2]) == cells[0];
      return *KuhnWallSearch(volume).Find({ wall.face[isFirst ? 0 : 1], wall.face[isFirst ? 1 : 0] });
    }
  }
  return {};
}

/** Cells side by side along the first axis, in a margin of exterior. */
LabelVolume
Row(std::int32_t count)
{
  return MakeImage({ { 4 * count + 4, 8, 8 } }, [=](std::int32_t x, std::int32_t y, std::int32_t z) {
    const bool isInside = x >= 2 && x < 4 * count + 2 && y >= 2 && y < 6 && z >= 2 && z < 6;
    return isInside ? VertexId{ 1 + (x - 2) / 4 } : ExteriorVertex;
  });
}
} // namespace

TEST(KuhnWall, OfOneCellIsClosed)
{
  const KuhnWall wall = WallOf(Row(1), { { 0, 1 } });
  EXPECT_EQ(wall.cells, (VertexPair{ { 0, 1 } }));
  EXPECT_EQ(wall.numberOfCircles, 0);
  EXPECT_TRUE(wall.closedLines.empty());
  EXPECT_FALSE(wall.IsSound());
}

TEST(KuhnWall, OfCellsInARowEndsAtClosedLines)
{
  const LabelVolume volume = Row(3);
  const KuhnWall    end = WallOf(volume, { { 0, 1 } });
  ASSERT_EQ(end.closedLines.size(), 1u);
  const VoxelIndex & third = end.closedLines[0].third;
  EXPECT_EQ(volume.At(third[0], third[1], third[2]), 2);
  EXPECT_EQ(WallOf(volume, { { 0, 2 } }).closedLines.size(), 2u);
  EXPECT_EQ(WallOf(volume, { { 1, 2 } }).closedLines.size(), 1u);
  EXPECT_EQ(WallOf(volume, { { 1, 2 } }).numberOfCircles, 0);
}

TEST(KuhnWall, OfSolidTissueIsSound)
{
  const LabelVolume volume = Bricks({ { 3, 3, 2 } }, 6);
  for (const ImageWall & wall : FindImageWalls(volume))
  {
    EXPECT_TRUE(WallOf(volume, wall.cells).IsSound()) << wall.cells[0] << ' ' << wall.cells[1];
  }
}

TEST(KuhnWall, IsFoundOnceFromAnyOfItsEdges)
{
  const LabelVolume volume = Row(2);
  KuhnWallSearch    search(volume);
  const auto        wall = search.Find({ { { 5, 4, 4 } }, { { 6, 4, 4 } } });
  ASSERT_TRUE(wall);
  EXPECT_FALSE(search.Find({ { { 5, 3, 3 } }, { { 6, 3, 3 } } }));
  for (const VoxelIndex & p : wall->voxels[0])
  {
    EXPECT_EQ(volume.At(p[0], p[1], p[2]), 1);
    EXPECT_EQ(p[0], 5);
  }
  EXPECT_TRUE(search.Find({ { { 1, 4, 4 } }, { { 2, 4, 4 } } })) << "another wall";
}
