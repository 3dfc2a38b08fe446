/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "itkImageNoiseCalculator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace
{
using ImageType = itk::Image<float, 3>;
using CalculatorType = itk::ImageNoiseCalculator<ImageType>;

/** What is shown, and normal noise of a deviation that depends on x. */
ImageType::Pointer
MakeNoisy(const std::function<double(long, long, long)> & shown, const std::function<double(long)> & deviation,
          const itk::Size<3> & size = { { 48, 40, 36 } })
{
  std::mt19937                     random(3);
  std::normal_distribution<double> normal;
  return tissue_test::MakeImage<float>(
    size, [&](long x, long y, long z) { return static_cast<float>(shown(x, y, z) + deviation(x) * normal(random)); });
}

CalculatorType::Pointer
Compute(const ImageType * image)
{
  const auto calculator = CalculatorType::New();
  calculator->SetImage(image);
  calculator->Compute();
  return calculator;
}

double
Nothing(long, long, long)
{
  return 0.0;
}

/** Walls, two or three voxels thick and blurred, that cross the axes askew, with as much space between. */
double
Walls(long x, long y, long z)
{
  const auto i = static_cast<double>(x);
  const auto j = static_cast<double>(y);
  const auto k = static_cast<double>(z);
  return 100.0 * (std::pow(std::sin(0.3 * (i + 0.5 * j)), 8) + std::pow(std::sin(0.35 * (k - 0.4 * i + 0.3 * j)), 8));
}
} // namespace

TEST(ImageNoiseCalculator, IsTheDeviationOfTheNoiseWhateverTheImageShows)
{
  for (const double deviation : { 3.0, 20.0 })
  {
    const auto noise = [deviation](long) { return deviation; };
    const auto slope = [](long x, long y, long z) { return static_cast<double>(5 * x * y - 7 * z); };
    for (const auto & shown : { std::function<double(long, long, long)>(Nothing),
                                std::function<double(long, long, long)>(slope),
                                std::function<double(long, long, long)>(Walls) })
    {
      EXPECT_NEAR(Compute(MakeNoisy(shown, noise))->GetDeviation() / deviation, 1.0, 0.1);
    }
  }
}

TEST(ImageNoiseCalculator, SeesNoneWhereThereIsNone)
{
  const auto none = [](long) { return 0.0; };
  EXPECT_EQ(Compute(MakeNoisy(Nothing, none))->GetDeviation(), 0.0);
  EXPECT_LT(Compute(MakeNoisy(Walls, none))->GetDeviation(), 1.0); // of 200
  // A few bright voxels are no noise.
  const auto voxels = [](long x, long y, long z) { return x % 12 == 5 && y % 12 == 5 && z % 12 == 5 ? 255.0 : 0.0; };
  EXPECT_EQ(Compute(MakeNoisy(voxels, none))->GetDeviation(), 0.0);
}

TEST(ImageNoiseCalculator, TellsWhereThereIsMore)
{
  const auto image = MakeNoisy(Nothing, [](long x) { return x < 24 ? 2.0 : 10.0; });
  const auto calculator = Compute(image);
  EXPECT_NEAR(calculator->GetLocalDeviation({ { 3, 20, 20 } }), 2.0, 0.3);
  EXPECT_NEAR(calculator->GetLocalDeviation({ { 45, 20, 20 } }), 10.0, 1.5);
  EXPECT_EQ(calculator->GetLocalDeviation({ { 0, 0, 0 } }), calculator->GetLocalDeviation({ { 2, 2, 2 } }));
  EXPECT_EQ(calculator->GetLocalDeviation({ { 47, 39, 35 } }), calculator->GetLocalDeviation({ { 44, 36, 33 } }));
}

TEST(ImageNoiseCalculator, ThinImagesCountByTheirLongAxes)
{
  const auto five = [](long) { return 5.0; };
  EXPECT_NEAR(Compute(MakeNoisy(Nothing, five, { { 60, 60, 1 } }))->GetDeviation(), 5.0, 0.5);
  EXPECT_NEAR(Compute(MakeNoisy(Nothing, five, { { 60, 60, 2 } }))->GetDeviation(), 5.0, 0.5);
  EXPECT_NEAR(Compute(MakeNoisy(Nothing, five, { { 60, 60, 3 } }))->GetDeviation(), 5.0, 0.5);
  EXPECT_EQ(Compute(MakeNoisy(Nothing, five, { { 2, 1, 2 } }))->GetDeviation(), 0.0);
}
