/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "StackLayout.h"

#include "StackTestFiles.h"

#include <gtest/gtest.h>

namespace
{
using namespace tissue;

std::optional<StackLayout>
Read(const std::string & description, std::size_t samples = 1)
{
  return ReadStackLayout(description, { 48, 44, samples }, "a.tif");
}

/** Channels, slices, frames. */
std::vector<std::size_t>
SizesOf(const std::optional<StackLayout> & layout)
{
  return { layout.value().numberOfChannels, layout->numberOfSlices, layout->numberOfFrames };
}

using Sizes = std::vector<std::size_t>;
} // namespace

TEST(StackLayout, NumbersThePagesByTheOrderOfTheAxes)
{
  const StackLayout layout = MakeStackLayout({ { 'Z', 5 }, { 'C', 2 }, { 'T', 3 } });
  for (std::size_t t = 0; t < 3; ++t)
  {
    for (std::size_t c = 0; c < 2; ++c)
    {
      for (std::size_t z = 0; z < 5; ++z)
      {
        EXPECT_EQ(layout.PageOf(c, z, t), static_cast<std::ptrdiff_t>((t * 2 + c) * 5 + z));
      }
    }
  }
  EXPECT_THROW(MakeStackLayout({ { 'Z', 100'000 }, { 'T', 100'000 } }), std::runtime_error);
}

TEST(StackLayout, ReadsImageJ)
{
  const auto layout = Read("ImageJ=1.53t\nimages=60\nchannels=2\nslices=10\nframes=3\nhyperstack=true\nmode=composite\n"
                           "unit=\\u00B5m\nspacing=0.9\nloop=false\nmin=0.0\nmax=65535.0\n");
  EXPECT_EQ(SizesOf(layout), (Sizes{ 2, 10, 3 }));
  EXPECT_EQ(layout->PageOf(1, 4, 2), (2 * 10 + 4) * 2 + 1);
  EXPECT_EQ(layout->unit, "\\u00B5m");
  EXPECT_EQ(layout->sliceDistance, 0.9);
  EXPECT_EQ(SizesOf(Read("ImageJ=1.53t\nimages=40\nslices=40\nunit=um\nspacing=-0.5\n")), (Sizes{ 1, 40, 1 }));
  EXPECT_EQ(Read("ImageJ=1.53t\nimages=40\nslices=40\nspacing=-0.5\n")->sliceDistance, 0.5) << "its sign is its order";
  EXPECT_EQ(SizesOf(Read("ImageJ=1.53t\nimages=40\nfps=7.0\n")), (Sizes{ 1, 40, 1 })) << "a plain stack";
  EXPECT_EQ(SizesOf(Read("ImageJ=1.53t\n")), (Sizes{ 1, 1, 1 }));
  EXPECT_EQ(Read("ImageJ=1.53t\nimages=2\nunit=mm\nzunit=um\nspacing=500\n")->sliceDistance, 0.5);
  EXPECT_NE(WordsOf([] { Read("ImageJ=1\nimages=41\nslices=20\nframes=2\n"); }).find("41 images"), std::string::npos);
  EXPECT_THROW(Read("ImageJ=1\nimages=many\n"), std::runtime_error);
}

TEST(StackLayout, ReadsShapes)
{
  EXPECT_EQ(SizesOf(Read(R"({"shape": [40, 44, 48]})")), (Sizes{ 1, 40, 1 }));
  EXPECT_EQ(SizesOf(Read(R"({"shape": [1, 40, 1, 44, 48]})")), (Sizes{ 1, 40, 1 }));
  EXPECT_EQ(SizesOf(Read(R"({"shape": [2, 40, 44, 48]})")), (Sizes{ 1, 40, 2 })) << "what they are is not told";
  EXPECT_EQ(SizesOf(Read(R"({"shape": [40, 44, 48, 2]})", 2)), (Sizes{ 1, 40, 1 }));
  const auto layout = Read(R"({"axes": "ZCYX", "spacing": 0.9, "unit": "um", "shape": [40, 2, 44, 48]})");
  EXPECT_EQ(SizesOf(layout), (Sizes{ 2, 40, 1 }));
  EXPECT_EQ(layout->PageOf(1, 7, 0), 15);
  EXPECT_EQ(layout->sliceDistance, 0.9);
  EXPECT_EQ(layout->unit, "um");
  EXPECT_EQ(SizesOf(Read(R"({"shape": [40, 44, 48], "axes": "IYX"})")), (Sizes{ 1, 40, 1 }));
  EXPECT_EQ(SizesOf(Read(R"({"shape": [40, 44, 48], "axes": "TYX"})")), (Sizes{ 1, 1, 40 }));
  EXPECT_EQ(Read(R"({"shape": [40, 40, 48]})"), std::nullopt) << "another image's";
  EXPECT_EQ(Read(R"({"key": 1})"), std::nullopt);
}

TEST(StackLayout, TakesManyChannelsOfOneSliceForSlicesWithAWarning)
{
  const auto layout = Read("ImageJ=1.11a\nimages=40\nchannels=40\nhyperstack=true\nmode=grayscale\n");
  EXPECT_EQ(SizesOf(layout), (Sizes{ 1, 40, 1 }));
  EXPECT_EQ(layout->PageOf(0, 39, 0), 39);
  ASSERT_EQ(layout->warnings.size(), 1u);
  EXPECT_NE(layout->warnings[0].find("40 planes channels"), std::string::npos);
  EXPECT_EQ(SizesOf(Read("ImageJ=1.11a\nimages=4\nchannels=4\n")), (Sizes{ 4, 1, 1 }));
}

TEST(StackLayout, KnowsNothingOfOtherDescriptions)
{
  for (const char * other : { "", "Made by a microscope", "<p>text</p>", "SCIFIO=1" })
  {
    EXPECT_EQ(Read(other), std::nullopt) << other;
  }
}
