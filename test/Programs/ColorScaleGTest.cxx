/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Pictures/ColorScale.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

using namespace tissue;

namespace
{
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const Color      grey{ { 178, 178, 178 } };
} // namespace

TEST(ColorScale, NumbersGoFromDarkToLightWithoutTheirOutliers)
{
  // 101 cells, one of them far off.
  PictureValues values{ "x", { unknown }, {} };
  for (int i = 0; i < 100; ++i)
  {
    values.numbers.push_back(i + 0.5);
  }
  values.numbers.push_back(1e6);
  const ColorScale scale(values);
  EXPECT_FALSE(scale.IsOfCategories());
  EXPECT_FALSE(scale.HasUnknown());
  EXPECT_DOUBLE_EQ(2.5, scale.GetTable()->GetTableRange()[0]);
  EXPECT_DOUBLE_EQ(98.5, scale.GetTable()->GetTableRange()[1]);
  EXPECT_EQ((Color{ { 68, 1, 84 } }), scale.GetColors()[1]);
  EXPECT_EQ((Color{ { 253, 231, 37 } }), scale.GetColors()[101]);
  for (std::size_t v = 2; v < 101; ++v)
  {
    const auto lightness = [](const Color & c) { return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]; };
    EXPECT_LE(lightness(scale.GetColors()[v - 1]), lightness(scale.GetColors()[v]) + 0.5) << v;
  }
}

TEST(ColorScale, WhatIsNotKnownIsGrey)
{
  const ColorScale scale({ "x", { unknown, 0.5, unknown, 0.7 }, {} });
  EXPECT_TRUE(scale.HasUnknown());
  EXPECT_EQ(grey, scale.GetColors()[2]);
  EXPECT_NE(grey, scale.GetColors()[1]);
  const ColorScale nothing({ "x", { unknown, unknown }, {} });
  EXPECT_EQ(grey, nothing.GetColors()[1]);
  const ColorScale same({ "x", { unknown, 0.25, 0.25 }, {} });
  EXPECT_LT(same.GetTable()->GetTableRange()[0], same.GetTable()->GetTableRange()[1]);
}

TEST(ColorScale, FewWholeNumbersAreCategories)
{
  const ColorScale scale({ "Layer", { 0, 2, 1, 1, 3, unknown }, {} });
  EXPECT_TRUE(scale.IsOfCategories());
  ASSERT_EQ(3, scale.GetTable()->GetNumberOfAnnotatedValues());
  EXPECT_EQ("1", scale.GetTable()->GetAnnotation(0));
  EXPECT_EQ("3", scale.GetTable()->GetAnnotation(2));
  EXPECT_EQ(scale.GetColors()[2], scale.GetColors()[3]);
  EXPECT_EQ(3u, (std::set<Color>{ scale.GetColors()[1], scale.GetColors()[2], scale.GetColors()[4] }).size());
  EXPECT_EQ(grey, scale.GetColors()[5]);
  EXPECT_FALSE(ColorScale({ "n", { 0, 1, 2, 3, 4, 5, 6, 7, 8 }, {} }).IsOfCategories());
  EXPECT_FALSE(ColorScale({ "x", { 0, 1, 1.5 }, {} }).IsOfCategories());
}

TEST(ColorScale, RareTextsAreTheOthers)
{
  PictureValues    values{ "fate", {}, { "", "z", "z", "", "a", "b", "c", "d", "e", "f", "g" } };
  const ColorScale scale(values);
  ASSERT_EQ(7, scale.GetTable()->GetNumberOfAnnotatedValues());
  EXPECT_EQ("z", scale.GetTable()->GetAnnotation(0));
  EXPECT_EQ("a", scale.GetTable()->GetAnnotation(1));
  EXPECT_EQ("others", scale.GetTable()->GetAnnotation(6));
  EXPECT_EQ(grey, scale.GetColors()[3]);
  EXPECT_EQ(scale.GetColors()[9], scale.GetColors()[10]);
  EXPECT_NE(scale.GetColors()[8], scale.GetColors()[9]);
}
