/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Image/ImagePlaces.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
/** Four voxels a side, of 1 x 2 x 3 units: cell 1 is half of it, 2 a quarter, 3 and 4 an eighth. */
LabelVolume
HalfQuarterAndEighths()
{
  LabelVolume volume;
  volume.size = { { 4, 4, 4 } };
  volume.steps = { { { { 1.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }, { { 0.0, 0.0, 3.0 } } } };
  for (int z = 0; z < 4; ++z)
  {
    for (int y = 0; y < 4; ++y)
    {
      for (int x = 0; x < 4; ++x)
      {
        volume.vertices.push_back(x < 2 ? 1 : y < 2 ? 2 : z < 2 ? 3 : 4);
      }
    }
  }
  return volume;
}

std::size_t
Count(const ImagePlaces & places, std::size_t group)
{
  return static_cast<std::size_t>(places.End(group) - places.Begin(group));
}
} // namespace

TEST(ImagePlaces, FacesOfEachWall)
{
  const ImagePlaces faces =
    CollectImageFaces(HalfQuarterAndEighths(), { { { 1, 2 } }, { { 4, 3 } }, { { 1, ExteriorVertex } } });
  EXPECT_EQ(Count(faces, 0), 8u);
  EXPECT_EQ(Count(faces, 1), 4u);
  EXPECT_EQ(Count(faces, 2), 48u); // all at the border: what is beyond it is exterior
  for (auto at = faces.Begin(0); at != faces.End(0); ++at)
  {
    EXPECT_EQ((*at)[0], 1.5f);
    EXPECT_TRUE((*at)[1] == 0.0f || (*at)[1] == 2.0f);
  }
  for (auto at = faces.Begin(1); at != faces.End(1); ++at)
  {
    EXPECT_EQ((*at)[2], 4.5f);
  }
}

TEST(ImagePlaces, AWallThatTheImageHasNotHasNone)
{
  const ImagePlaces faces = CollectImageFaces(HalfQuarterAndEighths(), { { { 1, 5 } }, { { 2, 3 } } });
  EXPECT_EQ(Count(faces, 0), 0u);
  EXPECT_EQ(Count(faces, 1), 4u);
}

TEST(ImagePlaces, EdgesOfEachLine)
{
  const ImagePlaces lines = CollectImageLines(HalfQuarterAndEighths(), { { { 1, 2, 3 } }, { { 1, 3, 4 } } });
  ASSERT_EQ(Count(lines, 0), 2u);
  EXPECT_EQ(lines.Begin(0)[0], (ImagePlaces::Place{ { 1.5f, 3.0f, 0.0f } }));
  EXPECT_EQ(lines.Begin(0)[1], (ImagePlaces::Place{ { 1.5f, 3.0f, 3.0f } }));
  ASSERT_EQ(Count(lines, 1), 2u);
  EXPECT_EQ(lines.Begin(1)[0], (ImagePlaces::Place{ { 1.5f, 4.0f, 4.5f } }));
  EXPECT_EQ(lines.Begin(1)[1], (ImagePlaces::Place{ { 1.5f, 6.0f, 4.5f } }));
}

TEST(ImagePlaces, RegroupsInPlaceAndKeepsTheOrder)
{
  const auto           placeOf = [](int i) { return ImagePlaces::Place{ { static_cast<float>(i), 0.0f, 0.0f } }; };
  ImagePlaces::Entries entries;
  for (int i = 0; i < 6; ++i)
  {
    entries.push_back({ i < 5 ? 0 : 1, placeOf(i) });
  }
  ImagePlaces places(2, entries);
  places.Regroup(4, [](std::size_t group) {
    return group == 0 ? std::vector<std::size_t>{ 3, 1, 3, 3, 1 } : std::vector<std::size_t>{ 0 };
  });
  ASSERT_EQ(Count(places, 0), 1u);
  ASSERT_EQ(Count(places, 1), 2u);
  EXPECT_EQ(Count(places, 2), 0u);
  ASSERT_EQ(Count(places, 3), 3u);
  EXPECT_EQ(places.Begin(0)[0], placeOf(5));
  EXPECT_EQ(places.Begin(1)[0], placeOf(1));
  EXPECT_EQ(places.Begin(1)[1], placeOf(4));
  EXPECT_EQ(places.Begin(3)[0], placeOf(0));
  EXPECT_EQ(places.Begin(3)[1], placeOf(2));
  EXPECT_EQ(places.Begin(3)[2], placeOf(3));
}
