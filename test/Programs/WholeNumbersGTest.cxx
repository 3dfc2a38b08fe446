/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/WholeNumbers.h"

#include "StackTestFiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
MakeImage(const std::vector<TPixel> & values)
{
  const auto image = itk::Image<TPixel, 3>::New();
  image->SetRegions(itk::Size<3>{ { 2, 1, values.size() / 2 } });
  image->Allocate();
  std::copy(values.begin(), values.end(), image->GetBufferPointer());
  const double spacing[] = { 0.3, 0.3, 0.9 };
  image->SetSpacing(spacing);
  return image;
}

template <typename TPixel>
std::vector<long long>
Convert(const std::vector<TPixel> & values, bool isScaled = false)
{
  const auto labels = tissue::ToWholeNumbers(MakeImage(values).GetPointer(), isScaled);
  EXPECT_EQ(labels->GetSpacing()[2], 0.9);
  return { labels->GetBufferPointer(), labels->GetBufferPointer() + values.size() };
}

template <typename TPixel>
std::string
Refusal(const std::vector<TPixel> & values, bool isScaled = false)
{
  return WordsOf([&] { Convert(values, isScaled); });
}

using Labels = std::vector<long long>;
} // namespace

TEST(WholeNumbers, AreTheirValues)
{
  EXPECT_EQ(Convert<float>({ 0.0f, -1.0f, 16777216.0f, 7.0f }), (Labels{ 0, -1, 16777216, 7 }));
  EXPECT_EQ(Convert<double>({ -0.0, 9007199254740992.0 }), (Labels{ 0, 9007199254740992 }));
}

TEST(WholeNumbers, RefuseTheFirstVoxelThatIsNone)
{
  EXPECT_NE(
    Refusal<float>({ 1.0f, 2.0f, 3.0f, 4.25f, 5.5f, 6.0f }).find("index (1, 0, 1) has the value 4.25, which is no"),
    std::string::npos);
  EXPECT_NE(Refusal<float>({ 1.0f, 1.0001f }).find("no whole number"), std::string::npos);
  for (const float value : { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity() })
  {
    EXPECT_NE(Refusal<float>({ 1.0f, value }).find("index (1, 0, 0)"), std::string::npos) << value;
  }
}

TEST(WholeNumbers, RefuseWhatTheTypeDoesNotHoldOneByOne)
{
  EXPECT_NE(Refusal<float>({ 1.0f, 16777218.0f }).find("the value 16777218, beyond the whole numbers"),
            std::string::npos);
  EXPECT_NE(Refusal<double>({ 1.0, -9007199254740994.0 }).find("2^53"), std::string::npos);
}

TEST(WholeNumbers, MayBeAThousandthOffWhereTheFileIsScaled)
{
  EXPECT_EQ(Convert<float>({ 1.0009f, 2.9995f }, true), (Labels{ 1, 3 }));
  EXPECT_NE(Refusal<float>({ 1.0f, 2.002f }, true).find("scaled by scl_slope"), std::string::npos);
  EXPECT_EQ(Refusal<float>({ 1.0f, 2.5f }).find("scl_slope"), std::string::npos);
}
