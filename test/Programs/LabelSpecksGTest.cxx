/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "Shared/Reconstruction/LabelSpecks.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace tissue;
using namespace tissue_test;

TEST(LabelSpecks, AreTheGreyValuesOfAStain)
{
  const auto noise = MakeNoise<short>({ { 12, 12, 12 } }, 20, 1);
  EXPECT_EQ(CountSpecks(noise.GetPointer()).labels, 20u);
  EXPECT_EQ(CountSpecks(noise.GetPointer()).specks, 20u);
  EXPECT_THROW(RequireNoSpecks(noise.GetPointer()), std::runtime_error);
}

TEST(LabelSpecks, AreNoCellsOfTwoVoxelsWidth)
{
  const auto cubes =
    MakeImage<short>({ { 8, 8, 8 } }, [](long x, long y, long z) { return 1 + x / 2 + 4 * (y / 2) + 16 * (z / 2); });
  EXPECT_EQ(CountSpecks(cubes.GetPointer()).labels, 64u);
  EXPECT_EQ(CountSpecks(cubes.GetPointer()).specks, 0u);
}

TEST(LabelSpecks, MayBeFewAmongCells)
{
  const auto       cubes = MakeImage<short>({ { 32, 32, 8 } }, [](long x, long y, long z) {
    return (x + 32 * y) % 40 == 0 && z == 3 ? 1000 + x + 32 * y : 1 + x / 8 + 4 * (y / 8);
  });
  const SpeckCount count = CountSpecks(cubes.GetPointer());
  EXPECT_EQ(count.labels, 16u + 26u);
  EXPECT_EQ(count.specks, 26u);
  // Most labels are specks, all the same.
  EXPECT_TRUE(count.IsNoLabelImage());
  EXPECT_FALSE((SpeckCount{ 42, 21 }).IsNoLabelImage());
  EXPECT_FALSE((SpeckCount{ 7, 7 }).IsNoLabelImage());
}

TEST(LabelSpecks, AreNoneWhereTheyHaveFewVoxelsAndMarkersAreCells)
{
  const auto markers = MakeImage<short>({ { 24, 24, 24 } }, [](long x, long y, long z) {
    const bool isMarker = x % 8 == 4 && y % 8 == 4 && z % 8 == 4;
    return isMarker ? 1 + x / 8 + 3 * (y / 8) + 9 * (z / 8) : 0;
  });
  EXPECT_EQ(CountSpecks(markers.GetPointer()).specks, 27u);
  EXPECT_EQ(CountSpecks(markers.GetPointer(), 64).specks, 0u);
}

TEST(LabelSpecks, OfASmoothStainAreLabelsInManyPieces)
{
  // Rings of equal values about the nuclei, which are as wide as two voxels.
  const auto image = MakeImage<short>({ { 48, 48, 48 } }, [](long x, long y, long z) {
    const auto away = [](long i) { return static_cast<double>(i % 16) - 7.5; };
    return 1 + std::min(9L, std::lround(std::hypot(away(x), away(y), away(z)) / 1.2));
  });
  EXPECT_NO_THROW(RequireNoSpecks(image.GetPointer()));
  EXPECT_THROW(RequireFewPieces(Extract(image.GetPointer())), std::runtime_error);
  EXPECT_NO_THROW(RequireFewPieces(Extract(MakeBallTissue<short>(30, 1).GetPointer())));
}
