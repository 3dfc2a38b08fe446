/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageFromText.h"
#include "itkMajorityLabelImageFilter.h"

#include <gtest/gtest.h>

namespace
{
using namespace tissue_test;
using Layers = std::vector<std::string>;

TextImageType::Pointer
Smooth(const Layers & layers, unsigned int numberOfWorkUnits = 1)
{
  auto filter = itk::MajorityLabelImageFilter<TextImageType>::New();
  filter->SetInput(LabelImageFromText(layers));
  filter->SetNumberOfWorkUnits(numberOfWorkUnits);
  filter->Update();
  return filter->GetOutput();
}
} // namespace

TEST(MajorityLabelImageFilter, FlatWallsStay)
{
  const Layers layers = { "aabb/aabb/aabb", "aabb/aabb/aabb", "cccc/cccc/cccc" };
  EXPECT_EQ(TextFromLabelImage(Smooth(layers)), layers);
}

TEST(MajorityLabelImageFilter, SingleVoxelVanishes)
{
  // Its own weight is 8 of 64.
  const Layers full(3, "aaa/aaa/aaa");
  Layers       layers = full;
  layers[1][5] = 'b';
  EXPECT_EQ(TextFromLabelImage(Smooth(layers)), full);
}

TEST(MajorityLabelImageFilter, WeighsByDistanceAndGoesOnBeyondTheBorder)
{
  // One row counts like 3 x 3 of them, of weights 1, 2, 1 along it. First voxel: a 3 of 4. Second: b 2, a 1, c 1.
  EXPECT_EQ(TextFromLabelImage(Smooth({ "abc" })), (Layers{ "abc" }));
  // In a plane the middle has 4 of 16 by itself, and the four b at its sides 8.
  EXPECT_EQ(TextFromLabelImage(Smooth({ "cbc/bab/cbc" }))[0][5], 'b');
}

TEST(MajorityLabelImageFilter, OwnLabelWinsAmongEqualsElseTheLeast)
{
  // In the middle all four have 4 of 16.
  EXPECT_EQ(TextFromLabelImage(Smooth({ "aca/dbd/aca" }))[0][5], 'b');
  // Of 64: a and c 16, b 8, d 24; then a and c 16, b, d, e and f 8.
  EXPECT_EQ(TextFromLabelImage(Smooth({ "ccc/ccc/ccc", "ddd/dbd/ddd", "aaa/aaa/aaa" }))[1][5], 'd');
  EXPECT_EQ(TextFromLabelImage(Smooth({ "ccc/ccc/ccc", "dfe/dbe/dfe", "aaa/aaa/aaa" }))[1][5], 'a');
}

TEST(MajorityLabelImageFilter, RequestedRegionGetsTheVoxelsOfTheWhole)
{
  const Layers layers = { "aabca/abbca/accca", "abcab/abcab/bbcaa", "abcaa/cbcab/aacba", "aacba/bbbca/cabac" };
  const auto   whole = Smooth(layers);
  auto         filter = itk::MajorityLabelImageFilter<TextImageType>::New();
  filter->SetInput(LabelImageFromText(layers));
  const TextImageType::RegionType region({ { 1, 1, 1 } }, { { 3, 2, 2 } });
  filter->GetOutput()->SetRequestedRegion(region);
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetBufferedRegion(), region);
  for (itk::IndexValueType z = 1; z < 3; ++z)
  {
    for (itk::IndexValueType y = 1; y < 3; ++y)
    {
      for (itk::IndexValueType x = 1; x < 4; ++x)
      {
        EXPECT_EQ(filter->GetOutput()->GetPixel({ { x, y, z } }), whole->GetPixel({ { x, y, z } }));
      }
    }
  }
  EXPECT_EQ(TextFromLabelImage(Smooth(layers, 4)), TextFromLabelImage(whole));
}
