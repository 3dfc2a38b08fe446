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
#include <functional>

using namespace tissue;

namespace
{
/** A blob on the x axis. */
Blob
MakeBlob(double x, double scale, double response)
{
  return { { { x, 0.0, 0.0 } }, scale, response };
}
} // namespace

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

TEST(BlobSelection, ThresholdLeavesOutWhatIsFarTooWeak)
{
  EXPECT_EQ(ChooseBlobThreshold(std::vector<double>()), 0.0);
  EXPECT_EQ(ChooseBlobThreshold({ 5.0 }), 5.0);
  EXPECT_EQ(ChooseBlobThreshold({ 5.0, 0.01, 0.02 }), 5.0);
}

TEST(BlobSelection, ThresholdDoesNotCutWhatFades)
{
  // Forty blobs whose responses fall evenly to a twentieth, all certain, and noise among the weakest ones.
  std::vector<Blob> certain;
  for (int i = 0; i < 40; ++i)
  {
    certain.push_back(MakeBlob(10.0 * i, 1.0, 100.0 * std::pow(0.05, i / 39.0)));
  }
  std::vector<Blob> all = certain;
  for (int i = 0; i < 300; ++i)
  {
    all.push_back(MakeBlob(10.0 * i, 1.0, 8.0 + 0.003 * i));
  }
  EXPECT_NEAR(ChooseBlobThreshold(certain, all), 5.0, 1e-9);
  // Of all there are few between noise and blobs: they go.
  for (Blob & blob : certain)
  {
    blob.response = 50.0 + 0.1 * blob.position[0];
  }
  certain.push_back(MakeBlob(0.0, 1.0, 3.0));
  all.insert(all.end(), certain.begin(), certain.end());
  all.erase(all.begin(), all.begin() + 40);
  for (std::size_t i = 0; i < 300; ++i)
  {
    all[i].response = 1.0 + 0.003 * static_cast<double>(i);
  }
  EXPECT_GT(ChooseBlobThreshold(certain, all), 3.0);
  EXPECT_LT(ChooseBlobThreshold(certain, all), 50.0);
}

TEST(BlobSelection, BlobsOfASecondSizeAreOfOneSizeAndFree)
{
  const BlobScaleRange range{ 2.0, 8.0 };
  std::vector<Blob>    most;
  std::vector<Blob>    maxima;
  for (int i = 0; i < 6; ++i)
  {
    most.push_back(MakeBlob(40.0 * i, 4.0, 100.0));
    maxima.push_back(MakeBlob(40.0 * i + 20.0, 1.3 + 0.02 * i, 60.0));
  }
  EXPECT_EQ(FindBlobsOfOtherSizes(maxima, most, range, 0.5).size(), 6u);
  EXPECT_TRUE(FindBlobsOfOtherSizes(maxima, {}, range, 0.5).empty());
  EXPECT_TRUE(FindBlobsOfOtherSizes({ maxima[0], maxima[1] }, most, range, 0.5).empty());
  // Larger ones, and those beyond twice the range, which do not count.
  std::vector<Blob> larger{ MakeBlob(500.0, 10.0, 40.0), MakeBlob(600.0, 11.0, 40.0), MakeBlob(700.0, 11.0, 40.0) };
  EXPECT_EQ(FindBlobsOfOtherSizes(larger, most, range, 0.5).size(), 3u);
  larger[0].scale = 17.0;
  EXPECT_TRUE(FindBlobsOfOtherSizes(larger, most, range, 0.5).empty());
  // Too weak, of all sizes, or within the others.
  const auto changed = [&](const std::function<void(Blob &, int)> & change) {
    std::vector<Blob> copy = maxima;
    for (int i = 0; i < 6; ++i)
    {
      change(copy[i], i);
    }
    return FindBlobsOfOtherSizes(copy, most, range, 0.5);
  };
  EXPECT_TRUE(changed([](Blob & blob, int) { blob.response = 24.0; }).empty());
  EXPECT_TRUE(changed([](Blob & blob, int i) { blob.scale = 1.05 + 0.18 * i; }).empty());
  EXPECT_TRUE(changed([](Blob & blob, int i) { blob.position[0] = 40.0 * i + 6.0; }).empty());
}

TEST(BlobSelection, BlobsAreWeakWhereThoseOfTheInverseAreAsStrong)
{
  std::vector<Blob> blobs;
  std::vector<Blob> inverse;
  for (int i = 0; i < 40; ++i)
  {
    blobs.push_back(MakeBlob(i, 1.0, 10.0 + i));
    inverse.push_back(MakeBlob(i, 1.0, 9.0 + i));
  }
  EXPECT_TRUE(AreBlobsWeak(blobs, inverse));
  for (Blob & blob : blobs)
  {
    blob.response *= 1.3;
  }
  EXPECT_FALSE(AreBlobsWeak(blobs, inverse));
  EXPECT_FALSE(AreBlobsWeak(blobs, {}));
  EXPECT_FALSE(AreBlobsWeak({}, {}));
  EXPECT_TRUE(AreBlobsWeak({ MakeBlob(0.0, 1.0, 5.0) }, { MakeBlob(0.0, 1.0, 5.0) }));
}

TEST(BlobSelection, FaintBlobsAmongBrightOnesAreDropped)
{
  std::vector<Blob> blobs;
  for (int i = 0; i < 60; ++i)
  {
    blobs.push_back(MakeBlob(3.0 * i, 1.0, 100.0 * std::pow(0.5, i / 6.0))); // fading to a thousandth
  }
  EXPECT_EQ(RemoveOutshoneBlobs(blobs).size(), 60u);
  blobs.push_back(MakeBlob(10.0, 1.0, 2.0));
  EXPECT_EQ(RemoveOutshoneBlobs(blobs).size(), 60u);
  EXPECT_EQ(RemoveOutshoneBlobs({ blobs[0], blobs[60] }).size(), 2u);
  EXPECT_TRUE(RemoveOutshoneBlobs({}).empty());
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
  EXPECT_NEAR(range.minimum, 2.0 / 2.18, 0.01);
  EXPECT_NEAR(range.maximum, 2.0 * 2.18, 0.04);
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
