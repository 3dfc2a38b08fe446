/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Adjacency/SuspectCells.h"
#include "VoxelTissue.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
/** A crop of 16 x 16 x 16 voxels within a tissue of cubes of 4 voxels, labels from 10 on, where another label may take
 * the place of some. The image has no exterior. */
template <typename TOther>
VoxelImage
Cubes(const TOther & otherAt)
{
  return { { { 16, 16, 16 } },
           [otherAt](int x, int y, int z) {
             const Label other = otherAt(x, y, z);
             return other > 0 ? other : Label{ 10 + x / 4 + 4 * (y / 4) + 16 * (z / 4) };
           },
           { false, 0, false } };
}

std::vector<std::pair<Label, Suspicion>>
Suspects(const VoxelImage & image)
{
  const JunctionSet                        junctions = JunctionsOf(image);
  std::vector<std::pair<Label, Suspicion>> suspects;
  for (const SuspectCell & suspect : FindSuspectCells(junctions))
  {
    suspects.emplace_back(junctions.cells[suspect.cell].label, suspect.suspicion);
  }
  return suspects;
}

using Pair = std::pair<Label, Suspicion>;
} // namespace

TEST(SuspectCells, AreNoneAmongCellsOfOneSize)
{
  EXPECT_TRUE(Suspects(Cubes([](int, int, int) { return 0; })).empty());
}

TEST(SuspectCells, AreSlabsOnTheBorderOfManyTimesTheMedianVolume)
{
  // A bent slab of 9 times the median volume.
  const auto slab = Cubes([](int x, int, int z) { return (z < 2 && x < 10) || (x < 1 && z < 15) ? 5 : 0; });
  ASSERT_GT(JunctionsOf(slab).cells[1].volume, 8.0 * 64.0);
  EXPECT_EQ(Suspects(slab), (std::vector<Pair>{ { 5, Suspicion::Large } }));
  // A compact cell of the same size is none.
  EXPECT_TRUE(Suspects(Cubes([](int x, int y, int z) { return x < 8 && y < 8 && z < 8 ? 5 : 0; })).empty());
}

TEST(SuspectCells, AreLargeCompactLabelsAtTheCornerOfTheImage)
{
  // A corner of 8 x 8 x 8 voxels: a label at the exterior by more than three fifths of its surface, beside cells.
  const auto labelAt = [](int x, int y, int z) {
    const bool isPocket = x < 8 && y < 8 && z < 8;
    if (isPocket)
    {
      return Label{ 5 };
    }
    return z < 8 ? Label{ 0 } : Label{ 10 + x / 4 + 4 * (y / 4) + 16 * (z / 4) };
  };
  const VoxelImage pocket{ { { 16, 16, 16 } }, labelAt, { true, 0, false } };
  EXPECT_EQ(Suspects(pocket), (std::vector<Pair>{ { 5, Suspicion::Pocket } }));
}

TEST(SuspectCells, AreLabelsInLargePiecesThatTheBorderDoesNotExplain)
{
  const auto inPieces = [](int second) {
    return Cubes([second](int x, int y, int z) {
      const bool isPiece = x / 2 == 3 && y / 2 == 3 && (z / 2 == 2 || z / 2 == second);
      return isPiece ? 5 : 0;
    });
  };
  EXPECT_EQ(Suspects(inPieces(5)), (std::vector<Pair>{ { 5, Suspicion::Pieces } }));
  EXPECT_TRUE(Suspects(inPieces(7)).empty());
  EXPECT_TRUE(Suspects(inPieces(2)).empty());
}

TEST(SuspectCells, NeedCellsOfAUsualSize)
{
  const VoxelImage few{ { { 16, 16, 4 } },
                        [](int x, int y, int) { return x > 0 && y > 0 ? Label{ 1 } : Label{ 2 + (x + y) / 6 }; },
                        { false, 0, false } };
  ASSERT_LT(JunctionsOf(few).cells.size(), 9u);
  EXPECT_TRUE(Suspects(few).empty());
}
