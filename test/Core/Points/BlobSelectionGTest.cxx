/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Points/BlobSelection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace tissue;

TEST(BlobSelection, ThresholdPartsTwoKindsThatDifferByAFactor)
{
  std::vector<double> responses;
  for (int i = 0; i < 300; ++i)
  {
    responses.push_back(1.0 + 0.002 * i);
  }
  for (int i = 0; i < 40; ++i)
  {
    responses.push_back(20.0 + 0.5 * i);
  }
  const double threshold = ChooseBlobThreshold(responses);
  EXPECT_GT(threshold, 1.6);
  EXPECT_LT(threshold, 20.0);
  for (double & response : responses)
  {
    response *= 1000.0;
  }
  EXPECT_NEAR(ChooseBlobThreshold(responses), 1000.0 * threshold, 1e-6 * threshold);
}

TEST(BlobSelection, ThresholdLeavesOneKindWhole)
{
  std::vector<double> responses{ 0.001 };
  for (int i = 0; i < 40; ++i)
  {
    responses.push_back(20.0 + 0.8 * i);
  }
  EXPECT_EQ(ChooseBlobThreshold(responses), 20.0); // exactly, or the weakest would be below it
}

TEST(BlobSelection, ThresholdOfLessThanTwoIsZero)
{
  EXPECT_EQ(ChooseBlobThreshold({}), 0.0);
  EXPECT_EQ(ChooseBlobThreshold({ 5.0 }), 0.0);
  EXPECT_EQ(ChooseBlobThreshold({ 5.0, 0.01 }), 0.0); // far too weak to count
}

TEST(BlobSelection, ScalesAreThoseThatExplainTheImage)
{
  std::vector<Blob> maxima;
  for (int i = 0; i < 2000; ++i)
  {
    maxima.push_back({ {}, 0.3, 10.0 }); // noise
  }
  for (int i = 0; i < 50; ++i)
  {
    maxima.push_back({ {}, 2.0 + 0.01 * (i % 3 - 1), 30.0 });
  }
  maxima.push_back({ {}, 9.0, 5.0 }); // a group
  const BlobScaleRange range = ChooseBlobScales(maxima);
  EXPECT_NEAR(range.minimum, 1.0, 0.01);
  EXPECT_NEAR(range.maximum, 4.0, 0.04);
  std::reverse(maxima.begin(), maxima.end());
  EXPECT_EQ(ChooseBlobScales(maxima).minimum, range.minimum);
  EXPECT_EQ(ChooseBlobScales({}).maximum, 0.0);
}

TEST(BlobSelection, TheWeakerOfTwoThatOverlapIsDropped)
{
  // Balls of radius 1; at a distance of 1 they have 5/16 of their volume in common.
  const double scale = 1.0 / BlobRadius(1.0);
  const Blob   strong{ { { 0.0, 0.0, 0.0 } }, scale, 5.0 };
  const Blob   weak{ { { 1.0, 0.0, 0.0 } }, scale, 4.0 };
  const Blob   far{ { { -7.0, 0.0, 0.0 } }, scale, 6.0 };
  const Blob   within{ { { 0.5, 0.0, 0.0 } }, 0.2 * scale, 1.0 };
  const auto   kept = RemoveOverlappingBlobs({ weak, strong, far, within }, 0.32);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[0].response, 6.0);
  EXPECT_EQ(kept[1].response, 5.0);
  EXPECT_EQ(kept[2].response, 4.0);
  EXPECT_EQ(RemoveOverlappingBlobs({ weak, strong, far, within }, 0.31).size(), 2u);
  EXPECT_EQ(RemoveOverlappingBlobs({ weak, strong, far, within }, 1.0).size(), 4u);
  EXPECT_TRUE(RemoveOverlappingBlobs({}, 0.5).empty());
}
