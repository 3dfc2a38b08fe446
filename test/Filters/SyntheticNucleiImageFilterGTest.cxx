/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "SyntheticTestTissue.h"
#include "itkSyntheticNucleiImageFilter.h"

#include <gtest/gtest.h>
#include <itkImageRegionConstIteratorWithIndex.h>
#include <itkImageRegionIterator.h>
#include <itkLabelImageToShapeLabelMapFilter.h>

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using LabelImageType = itk::Image<std::uint16_t, 3>;
using FilterType = itk::SyntheticNucleiImageFilter<LabelImageType>;
using OutputType = FilterType::OutputImageType;

/** Signal, background and noise of an image of this ratio of signal to noise. */
struct Levels
{
  explicit Levels(double signalToNoise)
    : signal(2.4 * signalToNoise * signalToNoise)
    , offset(20.0 * signalToNoise + 0.2 * signal)
    , noise(std::sqrt(1.4 * signal))
  {}

  double signal;
  /** Of the background, and the noise there. */
  double offset;
  double noise;
};

FilterType::Pointer
Stain(
  const LabelImageType * labels, const std::function<void(FilterType *)> & set = [](FilterType *) {})
{
  const auto filter = FilterType::New();
  filter->SetInput(labels);
  set(filter);
  filter->Update();
  return filter;
}

struct Moments
{
  double mean = 0.0;
  double deviation = 0.0;
  double greatest = 0.0;
};

/** Of the pixels whose index is chosen. */
Moments
Measure(const OutputType * image, const std::function<bool(const itk::Index<3> &)> & isChosen)
{
  double  count = 0.0;
  double  squares = 0.0;
  Moments moments;
  for (itk::ImageRegionConstIteratorWithIndex<OutputType> it(image, image->GetLargestPossibleRegion()); !it.IsAtEnd();
       ++it)
  {
    if (isChosen(it.GetIndex()))
    {
      count += 1.0;
      moments.mean += it.Get();
      squares += static_cast<double>(it.Get()) * it.Get();
      moments.greatest = std::max<double>(moments.greatest, it.Get());
    }
  }
  moments.mean /= count;
  moments.deviation = std::sqrt(squares / count - moments.mean * moments.mean);
  return moments;
}

std::vector<std::uint16_t>
PixelsOf(const OutputType * image)
{
  const auto * const begin = image->GetBufferPointer();
  return { begin, begin + image->GetLargestPossibleRegion().GetNumberOfPixels() };
}

/** One cell of 40 x 40 x 40 voxels in the middle of 60 x 60 x 60. */
LabelImageType::Pointer
MakeCube()
{
  const auto image = LabelImageType::New();
  image->SetRegions(itk::Size<3>{ { 60, 60, 60 } });
  image->Allocate(true);
  const LabelImageType::RegionType cell({ { 10, 10, 10 } }, { { 40, 40, 40 } });
  for (itk::ImageRegionIterator<LabelImageType> it(image, cell); !it.IsAtEnd(); ++it)
  {
    it.Set(7);
  }
  return image;
}

std::string
ErrorWith(const std::function<void(FilterType *)> & set)
{
  try
  {
    Stain(MakeCube(), set);
  }
  catch (const itk::ExceptionObject & error)
  {
    return error.GetDescription();
  }
  return "none";
}
} // namespace

TEST(SyntheticNucleiImageFilter, EveryCellHasANucleusOfItsSizeWithinIt)
{
  const auto labels = MakeSyntheticTestTissue<std::uint16_t>();
  // Turned and moved, as the nuclei are to be.
  LabelImageType::DirectionType direction;
  direction.Fill(0.0);
  direction[0][1] = -1.0;
  direction[1][2] = 1.0;
  direction[2][0] = -1.0;
  const double origin[] = { -7.0, 100.0, 3.0 };
  labels->SetDirection(direction);
  labels->SetOrigin(origin);
  const auto shapes = itk::LabelImageToShapeLabelMapFilter<LabelImageType>::New();
  shapes->SetInput(labels);
  shapes->Update();
  const auto filter = Stain(labels);
  EXPECT_EQ(filter->GetOutput()->GetDirection(), direction);
  EXPECT_EQ(filter->GetOutput()->GetOrigin(), labels->GetOrigin());
  EXPECT_EQ(filter->GetOutput()->GetSpacing(), labels->GetSpacing());
  const auto * const nuclei = filter->GetNuclei();
  ASSERT_EQ(nuclei->GetNumberOfPoints(), shapes->GetOutput()->GetNumberOfLabelObjects());
  double leastShare = 1.0;
  double mostShare = 0.0;
  for (unsigned int i = 0; i < nuclei->GetNumberOfPoints(); ++i)
  {
    const auto * const        cell = shapes->GetOutput()->GetNthLabelObject(i);
    const double              radius = std::cbrt(cell->GetPhysicalSize() * 3.0 / (4.0 * itk::Math::pi));
    const auto                data = nuclei->GetPointData()->GetElement(i);
    LabelImageType::IndexType index;
    ASSERT_TRUE(labels->TransformPhysicalPointToIndex(nuclei->GetPoint(i), index));
    EXPECT_EQ(data[0], cell->GetLabel());
    EXPECT_EQ(labels->GetPixel(index), cell->GetLabel());
    EXPECT_LT(nuclei->GetPoint(i).EuclideanDistanceTo(cell->GetCentroid()), 0.25 * radius + 0.2);
    leastShare = std::min(leastShare, data[1] / radius);
    mostShare = std::max(mostShare, data[1] / radius);
  }
  EXPECT_GE(leastShare, 0.4);
  EXPECT_LE(mostShare, 0.6);
  EXPECT_GT(mostShare - leastShare, 0.1);
}

TEST(SyntheticNucleiImageFilter, SignalAndNoiseAreInTheRatioAskedFor)
{
  const auto labels = MakeCube();
  for (const double ratio : { 2.0, 5.0, 20.0 })
  {
    const auto filter = Stain(labels, [ratio](FilterType * f) {
      f->SetSignalToNoise(ratio);
      f->SetBlur(0.0);
      f->SetRadiusShare(0.7);
      f->SetDecentering(0.0);
    });
    ASSERT_EQ(filter->GetNuclei()->GetNumberOfPoints(), 1u);
    const auto   center = filter->GetNuclei()->GetPoint(0);
    const double radius = filter->GetNuclei()->GetPointData()->GetElement(0)[1];
    const auto   distance = [&](const itk::Index<3> & index) {
      return labels->TransformIndexToPhysicalPoint<double>(index).EuclideanDistanceTo(center);
    };
    const Levels expected(ratio);
    const auto   outside =
      Measure(filter->GetOutput(), [&](const itk::Index<3> & index) { return distance(index) > radius + 1.0; });
    EXPECT_NEAR(outside.mean, expected.offset, 0.02 * expected.noise + 0.1) << ratio;
    // Rounding adds a twelfth to the variance.
    EXPECT_NEAR(outside.deviation, expected.noise, 0.02 * expected.noise + 0.02) << ratio;
    const auto inside =
      Measure(filter->GetOutput(), [&](const itk::Index<3> & index) { return distance(index) < radius - 1.0; });
    const double brightness = (inside.mean - outside.mean) / expected.signal;
    EXPECT_GT(brightness, 0.69) << ratio;
    EXPECT_LT(brightness, 1.31) << ratio;
    // Half of the variance are the photons of nucleus and background, where the brightness is 1.
    EXPECT_NEAR(inside.deviation, std::sqrt(expected.signal * (brightness + 1.4)), 0.04 * inside.deviation) << ratio;
  }
}

TEST(SyntheticNucleiImageFilter, NucleiThatAreLargerThanTheirCellsEndAtItsWalls)
{
  const auto labels = MakeSyntheticTestTissue<std::uint16_t>();
  const auto filter = Stain(labels, [](FilterType * f) {
    f->SetRadiusShare(0.99);
    f->SetDecentering(1.0);
    f->SetBlur(0.0);
    f->SetSignalToNoise(50.0);
  });
  const auto exterior =
    Measure(filter->GetOutput(), [&](const itk::Index<3> & index) { return labels->GetPixel(index) == 0; });
  const Levels expected(50.0);
  EXPECT_LT(exterior.greatest, expected.offset + 6.0 * expected.noise);
  EXPECT_NEAR(exterior.mean, expected.offset, 0.1 * expected.noise);
}

TEST(SyntheticNucleiImageFilter, BlurSmoothsByVoxelsAndKeepsTheSignal)
{
  const auto labels = MakeCube();
  const auto all = [](const itk::Index<3> &) { return true; };
  const auto stain = [&](double blur) {
    return Measure(Stain(labels,
                         [blur](FilterType * f) {
                           f->SetBlur(blur);
                           f->SetSignalToNoise(50.0);
                         })
                     ->GetOutput(),
                   all);
  };
  const auto sharp = stain(0.0);
  const auto blurred = stain(4.0);
  EXPECT_NEAR(blurred.mean, sharp.mean, 0.01 * sharp.mean);
  EXPECT_LT(blurred.deviation, 0.95 * sharp.deviation);
}

TEST(SyntheticNucleiImageFilter, EverySeedGivesOtherNucleiAndAnyNumberOfThreadsTheSame)
{
  const auto labels = MakeSyntheticTestTissue<std::uint16_t>();
  const auto one = Stain(labels, [](FilterType * f) { f->SetNumberOfWorkUnits(1); });
  const auto three = Stain(labels, [](FilterType * f) { f->SetNumberOfWorkUnits(3); });
  const auto other = Stain(labels, [](FilterType * f) { f->SetSeed(1); });
  EXPECT_EQ(PixelsOf(one->GetOutput()), PixelsOf(three->GetOutput()));
  EXPECT_NE(PixelsOf(one->GetOutput()), PixelsOf(other->GetOutput()));
  EXPECT_EQ(one->GetNuclei()->GetPoint(5), three->GetNuclei()->GetPoint(5));
  EXPECT_NE(one->GetNuclei()->GetPoint(5), other->GetNuclei()->GetPoint(5));
}

TEST(SyntheticNucleiImageFilter, TheExteriorHasNoNucleus)
{
  const auto labels = MakeCube();
  const auto cube = Stain(labels, [](FilterType * f) { f->SetExteriorLabel(0); });
  ASSERT_EQ(cube->GetNuclei()->GetNumberOfPoints(), 1u);
  EXPECT_EQ(cube->GetNuclei()->GetPointData()->GetElement(0)[0], 7.0);
  labels->FillBuffer(3);
  EXPECT_EQ(Stain(labels)->GetNuclei()->GetPointData()->GetElement(0)[0], 3.0);
  const auto empty = Stain(labels, [](FilterType * f) { f->SetExteriorLabel(3); });
  EXPECT_EQ(empty->GetNuclei()->GetNumberOfPoints(), 0u);
  const auto noise = Measure(empty->GetOutput(), [](const itk::Index<3> &) { return true; });
  EXPECT_NEAR(noise.mean, Levels(5.0).offset, 0.1);
}

TEST(SyntheticNucleiImageFilter, RefusesParametersOutOfRange)
{
  for (const double bad : { -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    EXPECT_NE(ErrorWith([bad](FilterType * f) { f->SetRadiusShare(bad); }).find("radius share"), std::string::npos);
    EXPECT_NE(ErrorWith([bad](FilterType * f) { f->SetSignalToNoise(bad); }).find("signal to noise"),
              std::string::npos);
    EXPECT_NE(ErrorWith([bad](FilterType * f) { f->SetBlur(bad); }).find("Blur"), std::string::npos);
    EXPECT_NE(ErrorWith([bad](FilterType * f) { f->SetDecentering(bad); }).find("decentering"), std::string::npos);
  }
  EXPECT_NE(ErrorWith([](FilterType * f) { f->SetRadiusShare(1.0); }).find("is 1, must be above 0 and below 1"),
            std::string::npos);
  EXPECT_NE(ErrorWith([](FilterType * f) { f->SetSignalToNoise(0.0); }).find("is 0, must be above 0 and at most 100"),
            std::string::npos);
  EXPECT_EQ(ErrorWith([](FilterType * f) { f->SetSignalToNoise(100.0); }), "none");
}

TEST(SyntheticNucleiImageFilter, BrightestNucleiFitTheirPixels)
{
  const auto filter =
    Stain(MakeSyntheticTestTissue<std::uint16_t>(), [](FilterType * f) { f->SetSignalToNoise(100.0); });
  const auto all = Measure(filter->GetOutput(), [](const itk::Index<3> &) { return true; });
  EXPECT_LT(all.greatest, 65535.0);
}
