/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Common/Random.h"
#include "itkDifferenceOfGaussiansBlobDetectionFilter.h"
#include "itkDiscreteGaussianImageFilter.h"
#include "itkImageRegionIteratorWithIndex.h"
#include "itkSyntheticNucleiImageFilter.h"
#include "itkSyntheticTissueImageSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <utility>

namespace
{
using ImageType = itk::Image<float, 3>;
using FilterType = itk::DifferenceOfGaussiansBlobDetectionFilter<ImageType>;
using PointType = itk::Point<double, 3>;

/** Voxels of 1 x 1 x 2 units, the axes turned, the first voxel elsewhere; a value for every physical point. */
ImageType::Pointer
MakeImage(const std::function<double(const PointType &)> & value, const ImageType::SizeType & size = { { 48, 48, 24 } })
{
  const auto               image = ImageType::New();
  ImageType::DirectionType direction;
  direction.Fill(0.0);
  direction(0, 1) = 1.0;
  direction(1, 2) = 1.0;
  direction(2, 0) = 1.0;
  const double spacing[] = { 1.0, 1.0, 2.0 };
  const double origin[] = { 10.0, -20.0, 30.0 };
  image->SetRegions(ImageType::RegionType({ { 3, -2, 5 } }, size));
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
  for (itk::ImageRegionIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    PointType point;
    image->TransformIndexToPhysicalPoint(it.GetIndex(), point);
    it.Set(static_cast<float>(value(point)));
  }
  return image;
}

PointType
Middle(double x = 23.3, double y = 23.8, double z = 11.4)
{
  itk::ContinuousIndex<double, 3> index;
  index[0] = 3 + x;
  index[1] = -2 + y;
  index[2] = 5 + z;
  PointType point;
  MakeImage([](const PointType &) { return 0.0; }, { { 1, 1, 1 } })
    ->TransformContinuousIndexToPhysicalPoint(index, point);
  return point;
}

double
Gaussian(const PointType & point, const PointType & center, double deviation)
{
  return std::exp(-0.5 * point.SquaredEuclideanDistanceTo(center) / (deviation * deviation));
}

FilterType::Pointer
MakeFilter(const ImageType * image, double minimum = 1.5, double maximum = 6.0)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->SetMinimumScale(minimum);
  filter->SetMaximumScale(maximum);
  return filter;
}

FilterType::Pointer
Detect(
  const ImageType * image, const std::function<void(FilterType *)> & set = [](FilterType *) {})
{
  const auto filter = MakeFilter(image);
  set(filter);
  filter->Update();
  return filter;
}

void
Threshold(FilterType * filter)
{
  filter->SetRelativeThreshold(0.2);
}
} // namespace

TEST(DifferenceOfGaussiansBlobDetectionFilter, FindsPositionAndScaleOfAGaussian)
{
  for (const double deviation : { 2.5, 3.3, 5.0 })
  {
    const PointType center = Middle();
    const auto      filter =
      Detect(MakeImage([&](const PointType & p) { return Gaussian(p, center, deviation); }), Threshold);
    ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 1u) << deviation;
    EXPECT_LT(filter->GetOutput()->GetPoint(0).EuclideanDistanceTo(center), 0.1 * std::cbrt(2.0)) << deviation;
    // -sigma^2 times the Laplacian of a smoothed Gaussian is greatest at sqrt(2/3) of its deviation.
    const auto data = filter->GetOutput()->GetPointData()->GetElement(0);
    EXPECT_NEAR(data[0] / (std::sqrt(2.0 / 3.0) * deviation), 1.0, 0.05) << deviation;
    // Where it is 3 (2/3) (3/5)^(5/2) of the height.
    EXPECT_NEAR(data[1], 2.0 * std::pow(0.6, 2.5), 0.03) << deviation;
  }
}

TEST(DifferenceOfGaussiansBlobDetectionFilter, ABallAnswersAtItsRadius)
{
  const PointType center = Middle();
  const auto      filter = Detect(
    MakeImage([&](const PointType & p) { return p.EuclideanDistanceTo(center) < 6.0 ? 100.0 : 0.0; }), Threshold);
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 1u);
  EXPECT_NEAR(tissue::BlobRadius(filter->GetOutput()->GetPointData()->GetElement(0)[0]), 6.0, 0.4);
}

TEST(DifferenceOfGaussiansBlobDetectionFilter, DarkBlobsAreTheBrightOnesOfTheInverse)
{
  const auto value = [](const PointType & p) { return Gaussian(p, Middle(), 3.0); };
  const auto inverse = [&value](const PointType & p) { return 7.0 - value(p); };
  EXPECT_EQ(Detect(MakeImage(inverse), [](FilterType * filter) { filter->SetThreshold(0.2); })
              ->GetOutput()
              ->GetNumberOfPoints(),
            0u);
  const auto dark = Detect(MakeImage(inverse), [](FilterType * filter) {
    filter->SetThreshold(0.2);
    filter->DarkBlobsOn();
  });
  ASSERT_EQ(dark->GetOutput()->GetNumberOfPoints(), 1u);
  EXPECT_LT(dark->GetOutput()->GetPoint(0).EuclideanDistanceTo(Middle()), 0.1);
}

TEST(DifferenceOfGaussiansBlobDetectionFilter, TubesAndWallsAreNoBlobs)
{
  const auto distanceToMiddle = [](const PointType & p, unsigned int axis) { return p[axis] - Middle()[axis]; };
  // A tube that swells a little, and a wall that does.
  const auto tube = [&](const PointType & p) {
    const double r2 = std::pow(distanceToMiddle(p, 0), 2) + std::pow(distanceToMiddle(p, 1), 2);
    return std::exp(-0.5 * r2 / 9.0) * (1.0 + 0.05 * Gaussian(p, Middle(), 8.0));
  };
  const auto wall = [&](const PointType & p) {
    return std::exp(-0.5 * std::pow(distanceToMiddle(p, 1), 2) / 9.0) * (1.0 + 0.05 * Gaussian(p, Middle(), 8.0));
  };
  for (const auto & value :
       { std::function<double(const PointType &)>(tube), std::function<double(const PointType &)>(wall) })
  {
    const auto image = MakeImage(value);
    EXPECT_EQ(Detect(image, Threshold)->GetOutput()->GetNumberOfPoints(), 0u);
    const auto all = Detect(image, [](FilterType * filter) {
      Threshold(filter);
      filter->SetMaximumHessianRatio(0.0);
    });
    EXPECT_GE(all->GetOutput()->GetNumberOfPoints(), 1u);
  }
}

TEST(DifferenceOfGaussiansBlobDetectionFilter, OverlapAndBorderMarginAndThreshold)
{
  const PointType first = Middle(16.0, 24.0, 12.0);
  const PointType second = Middle(25.0, 24.0, 12.0);
  const auto      image =
    MakeImage([&](const PointType & p) { return Gaussian(p, first, 3.0) + 0.8 * Gaussian(p, second, 3.0); });
  const auto both = Detect(image, Threshold);
  ASSERT_EQ(both->GetOutput()->GetNumberOfPoints(), 2u);
  EXPECT_LT(both->GetOutput()->GetPoint(0).EuclideanDistanceTo(first), 0.5); // the stronger one comes first
  EXPECT_EQ(Detect(image,
                   [](FilterType * filter) {
                     Threshold(filter);
                     filter->SetMaximumOverlap(0.0);
                   })
              ->GetOutput()
              ->GetNumberOfPoints(),
            2u);
  EXPECT_EQ(Detect(image,
                   [](FilterType * filter) {
                     Threshold(filter);
                     filter->SetBorderMargin(17.5);
                   })
              ->GetOutput()
              ->GetNumberOfPoints(),
            1u);
  const auto strong = Detect(image, [](FilterType * filter) { filter->SetRelativeThreshold(0.95); });
  EXPECT_EQ(strong->GetOutput()->GetNumberOfPoints(), 1u);
  EXPECT_GT(strong->GetUsedThreshold(), 0.0);
}

/** The two scales. */
class SyntheticNuclei : public ::testing::TestWithParam<std::pair<double, double>>
{};

TEST_P(SyntheticNuclei, AreFoundForAnyNumberOfThreads)
{
  using LabelImage = itk::Image<unsigned short, 3>;
  const auto   tissue = itk::SyntheticTissueImageSource<LabelImage>::New();
  const double spacing[] = { 1.0, 1.0, 3.0 };
  tissue->SetSize(itk::Size<3>{ { 110, 110, 36 } });
  tissue->SetSpacing(spacing);
  tissue->SetNumberOfCells(80);
  const auto stain = itk::SyntheticNucleiImageFilter<LabelImage>::New();
  stain->SetInput(tissue->GetOutput());
  stain->SetNumberOfWorkUnits(3);
  stain->Update();
  const auto again = itk::SyntheticNucleiImageFilter<LabelImage>::New();
  again->SetInput(tissue->GetOutput());
  again->SetNumberOfWorkUnits(1);
  again->Update();
  const auto numberOfVoxels = stain->GetOutput()->GetBufferedRegion().GetNumberOfPixels();
  ASSERT_TRUE(std::equal(stain->GetOutput()->GetBufferPointer(),
                         stain->GetOutput()->GetBufferPointer() + numberOfVoxels,
                         again->GetOutput()->GetBufferPointer()));

  using DetectionType =
    itk::DifferenceOfGaussiansBlobDetectionFilter<itk::SyntheticNucleiImageFilter<LabelImage>::OutputImageType>;
  std::vector<DetectionType::Pointer> detections;
  for (const unsigned int workUnits : { 1u, 4u })
  {
    const auto detection = DetectionType::New();
    detection->SetInput(stain->GetOutput());
    detection->SetMinimumScale(GetParam().first);
    detection->SetMaximumScale(GetParam().second);
    detection->SetNumberOfWorkUnits(workUnits);
    detection->Update();
    detections.push_back(detection);
  }
  const auto * const blobs = detections[0]->GetOutput();
  ASSERT_EQ(blobs->GetNumberOfPoints(), detections[1]->GetOutput()->GetNumberOfPoints());
  for (unsigned int i = 0; i < blobs->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(blobs->GetPoint(i), detections[1]->GetOutput()->GetPoint(i));
    EXPECT_EQ(blobs->GetPointData()->GetElement(i), detections[1]->GetOutput()->GetPointData()->GetElement(i));
  }

  // Every nucleus has its blob, and no blob is far from all nuclei.
  const auto * const nuclei = stain->GetNuclei();
  int                found = 0;
  double             errors = 0.0;
  for (unsigned int n = 0; n < nuclei->GetNumberOfPoints(); ++n)
  {
    double least = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < blobs->GetNumberOfPoints(); ++i)
    {
      least = std::min(least, nuclei->GetPoint(n).EuclideanDistanceTo(blobs->GetPoint(i)));
    }
    const bool isFound = least < nuclei->GetPointData()->GetElement(n)[1];
    found += isFound ? 1 : 0;
    errors += isFound ? least : 0.0;
  }
  EXPECT_GE(found, 79);
  EXPECT_LE(blobs->GetNumberOfPoints(), 81u);
  EXPECT_LT(errors / found, 0.5 * std::cbrt(3.0));
}

INSTANTIATE_TEST_SUITE_P(GivenAndFoundScales, SyntheticNuclei,
                         ::testing::Values(std::make_pair(1.5, 6.0), std::make_pair(0.0, 0.0)));

TEST(DifferenceOfGaussiansBlobDetectionFilter, FindsTheScalesOfBlobsInNoise)
{
  tissue::Random random(1);
  const auto     image = MakeImage([&](const PointType & p) {
    double value = 0.5 * random.Uniform();
    for (const double x : { 10.0, 24.0, 38.0 })
    {
      for (const double y : { 10.0, 24.0, 38.0 })
      {
        value += Gaussian(p, Middle(x, y, 12.0), 3.3);
      }
    }
    return value;
  });
  const auto     filter = MakeFilter(image, 0.0, 0.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 9u);
  const double scale = std::sqrt(2.0 / 3.0) * 3.3;
  EXPECT_NEAR(filter->GetUsedMinimumScale(), 0.5 * scale, 0.1 * scale);
  EXPECT_NEAR(filter->GetUsedMaximumScale(), 2.0 * scale, 0.4 * scale);
}

TEST(DifferenceOfGaussiansBlobDetectionFilter, NoiseAloneHasNoBlobs)
{
  std::mt19937                     random(5);
  std::normal_distribution<double> normal;
  std::poisson_distribution<int>   photons(9.0);
  const auto gaussian = MakeImage([&](const PointType &) { return 40.0 + 12.0 * normal(random); });
  const auto counted = MakeImage([&](const PointType &) { return static_cast<double>(photons(random)); });
  for (const auto & [image, deviation] : { std::make_pair(gaussian, 12.0), std::make_pair(counted, 3.0) })
  {
    const auto filter = MakeFilter(image, 0.0, 0.0);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0u);
    EXPECT_NEAR(filter->GetNoise(), deviation, 0.1 * deviation);
    EXPECT_FALSE(filter->GetHasWeakEvidence());
    EXPECT_GT(Detect(image, Threshold)->GetOutput()->GetNumberOfPoints(), 5u);
  }
  // Of smoothed noise too little is seen, but the dark blobs are as strong.
  const auto smooth = itk::DiscreteGaussianImageFilter<ImageType, ImageType>::New();
  smooth->SetInput(gaussian);
  smooth->SetUseImageSpacing(false);
  smooth->SetVariance(1.0);
  smooth->Update();
  const auto filter = MakeFilter(smooth->GetOutput(), 0.0, 0.0);
  filter->Update();
  EXPECT_TRUE(filter->GetHasWeakEvidence());
  EXPECT_LT(filter->GetOutput()->GetNumberOfPoints(), 20u);
}

TEST(DifferenceOfGaussiansBlobDetectionFilter, BlobsOnBlackAreThemselves)
{
  // A ball alone, and single voxels: no remainders of either at the border or between.
  const auto ball = MakeFilter(
    MakeImage([](const PointType & p) { return p.EuclideanDistanceTo(Middle()) < 5.0 ? 200.0 : 0.0; }), 0.0, 0.0);
  ball->Update();
  ASSERT_EQ(ball->GetOutput()->GetNumberOfPoints(), 1u);
  EXPECT_LT(ball->GetOutput()->GetPoint(0).EuclideanDistanceTo(Middle()), 0.5);
  EXPECT_EQ(ball->GetNoise(), 0.0);

  const auto                   image = MakeImage([](const PointType &) { return 0.0; });
  const std::vector<PointType> places{ Middle(8, 9, 5), Middle(30, 12, 16), Middle(20, 40, 10), Middle(41, 33, 4) };
  for (const PointType & place : places)
  {
    ImageType::IndexType index;
    image->TransformPhysicalPointToIndex(place, index);
    image->SetPixel(index, 1.0f);
  }
  const auto voxels = MakeFilter(image, 0.0, 0.0);
  voxels->Update();
  ASSERT_EQ(voxels->GetOutput()->GetNumberOfPoints(), places.size());
  for (unsigned int i = 0; i < places.size(); ++i)
  {
    const PointType point = voxels->GetOutput()->GetPoint(i);
    EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&point](const PointType & place) {
      return point.EuclideanDistanceTo(place) < 0.5;
    }));
  }
}

TEST(DifferenceOfGaussiansBlobDetectionFilter, FindsBlobsOfTwoSizes)
{
  std::mt19937                     random(6);
  std::normal_distribution<double> normal;
  for (const double noise : { 0.0, 6.0 })
  {
    const auto image = MakeImage([&](const PointType & p) {
      double value = noise * normal(random);
      for (const double x : { 10.0, 38.0 })
      {
        for (const double y : { 10.0, 38.0 })
        {
          value += 100.0 * Gaussian(p, Middle(x, y, 11.0), 4.5);
          value += 100.0 * Gaussian(p, Middle(24.0, x, y / 2.0), 1.7);
        }
      }
      return value;
    });
    const auto filter = MakeFilter(image, 0.0, 0.0);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 8u) << noise;
    EXPECT_LT(filter->GetUsedMinimumScale(), 1.7) << noise;
    EXPECT_GT(filter->GetUsedMaximumScale(), 3.5) << noise;
  }
}

TEST(DifferenceOfGaussiansBlobDetectionFilter, ReportsProgressOfTheWhole)
{
  const auto filter = MakeFilter(MakeImage([](const PointType & p) { return Gaussian(p, Middle(), 3.0); }));
  float      last = 0.0f;
  bool       isAscending = true;
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    isAscending = isAscending && filter->GetProgress() >= last;
    last = filter->GetProgress();
  });
  filter->Update();
  EXPECT_TRUE(isAscending);
  EXPECT_EQ(last, 1.0f);
}

TEST(DifferenceOfGaussiansBlobDetectionFilter, RefusesWhatHasNoScaleSpace)
{
  const auto constant = MakeImage([](const PointType &) { return 3.0; });
  EXPECT_THROW(MakeFilter(constant)->Update(), itk::ExceptionObject);
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    const auto image = MakeImage([](const PointType & p) { return Gaussian(p, Middle(), 3.0); });
    image->GetBufferPointer()[77] = static_cast<float>(bad);
    EXPECT_THROW(MakeFilter(image)->Update(), itk::ExceptionObject);
  }
  const auto image = MakeImage([](const PointType & p) { return Gaussian(p, Middle(), 3.0); });
  EXPECT_THROW(MakeFilter(image, 0.4)->Update(), itk::ExceptionObject);
  EXPECT_NO_THROW(MakeFilter(image, 0.5)->Update());
  EXPECT_THROW(MakeFilter(image, 2.0, 49.0)->Update(), itk::ExceptionObject);
  EXPECT_THROW(MakeFilter(image, 3.0, 2.0)->Update(), itk::ExceptionObject);
  EXPECT_THROW(MakeFilter(image, 0.0, 2.0)->Update(), itk::ExceptionObject);
  EXPECT_THROW(MakeFilter(image, 2.0, 0.0)->Update(), itk::ExceptionObject);
}

TEST(DifferenceOfGaussiansBlobDetectionFilter, AnImageWithoutBlobsGivesNone)
{
  const auto slope = MakeImage([](const PointType & p) { return p[0] + 2.0 * p[1]; });
  EXPECT_EQ(Detect(slope, [](FilterType * filter) { filter->SetThreshold(0.5); })->GetOutput()->GetNumberOfPoints(),
            0u);
}
