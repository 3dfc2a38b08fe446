/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "MembraneImage.h"
#include "itkMembraneToTissueLabelImageFilter.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

namespace
{
using LabelImageType = itk::Image<short, 3>;
template <typename TPixel>
using MembraneImageType = itk::Image<TPixel, 3>;

/** A ball of cells of about 12 voxels, in voxels twice as long in z as in the plane, turned and moved. */
LabelImageType::Pointer
MakeTissue()
{
  const auto                    ball = tissue_test::MakeBallTissue<short>(60, 3);
  const auto                    image = tissue_test::MakeImage<short>({ { 60, 60, 30 } }, [&](long x, long y, long z) {
    return ball->GetPixel({ { x, y, 2 * z } });
  });
  LabelImageType::DirectionType direction;
  direction.SetIdentity();
  direction[0][0] = direction[1][1] = 0.6;
  direction[0][1] = -0.8;
  direction[1][0] = 0.8;
  image->SetDirection(direction);
  image->SetSpacing(itk::Vector<double, 3>(std::array<double, 3>{ { 0.5, 0.5, 1.0 } }.data()));
  image->SetOrigin(itk::Point<double, 3>(std::array<double, 3>{ { 10.0, -20.0, 5.0 } }.data()));
  return image;
}

/** The cells as a guess has them: by every second voxel, in the same place, each a voxel too far along x. */
LabelImageType::Pointer
MakeGuess(const LabelImageType * labels)
{
  const auto guess = tissue_test::MakeImage<short>({ { 30, 30, 15 } }, [&](long x, long y, long z) {
    return labels->GetPixel({ { std::max(2 * x - 1, 0L), 2 * y, 2 * z } });
  });
  guess->CopyInformation(labels);
  guess->SetSpacing(2.0 * labels->GetSpacing());
  return guess;
}

/** 27 cubes, labels 1 ... 27, in a margin of label 0. */
LabelImageType::Pointer
MakeCubes(long edge, long margin)
{
  const auto size = static_cast<itk::SizeValueType>(3 * edge + 2 * margin);
  return tissue_test::MakeImage<short>({ { size, size, size } }, [edge, margin](long x, long y, long z) {
    const auto place = [edge, margin](long i) {
      return i < margin || i >= margin + 3 * edge ? -1 : (i - margin) / edge;
    };
    const bool isInside = place(x) >= 0 && place(y) >= 0 && place(z) >= 0;
    return isInside ? 1 + place(x) + 3 * place(y) + 9 * place(z) : 0;
  });
}

template <typename TPixel>
LabelImageType::Pointer
Segment(const MembraneImageType<TPixel> * membrane, const LabelImageType * cells, unsigned int workUnits = 2)
{
  const auto filter = itk::MembraneToTissueLabelImageFilter<MembraneImageType<TPixel>, LabelImageType>::New();
  filter->SetInput(membrane);
  if (cells != nullptr)
  {
    filter->SetCellImage(cells);
  }
  filter->SetNumberOfWorkUnits(workUnits);
  filter->Update();
  return filter->GetOutput();
}

template <typename TPixel>
std::string
ErrorOf(const MembraneImageType<TPixel> * membrane, const LabelImageType * cells)
{
  try
  {
    Segment<TPixel>(membrane, cells);
  }
  catch (const itk::ExceptionObject & error)
  {
    return error.GetDescription();
  }
  return "none";
}

std::set<short>
LabelsOf(const LabelImageType * image)
{
  const short * const begin = image->GetBufferPointer();
  return std::set<short>(begin, begin + image->GetLargestPossibleRegion().GetNumberOfPixels());
}
} // namespace

TEST(MembraneToTissueLabelImageFilter, FindsTheCellsOfAGuessOnAnotherGridWithTheirLabels)
{
  const auto labels = MakeTissue();
  const auto guess = MakeGuess(labels);
  const auto segmented =
    Segment<unsigned char>(tissue_test::MakeMembraneImage<unsigned char>(labels.GetPointer()), guess);
  EXPECT_EQ(segmented->GetOrigin(), labels->GetOrigin());
  EXPECT_EQ(segmented->GetDirection(), labels->GetDirection());
  EXPECT_EQ(LabelsOf(segmented), LabelsOf(guess));
  EXPECT_GE(tissue_test::Agreement<LabelImageType>(segmented, labels), 0.92);
}

TEST(MembraneToTissueLabelImageFilter, IsTheSameForAnyPixelTypeAndNumberOfWorkUnits)
{
  const auto labels = MakeTissue();
  const auto guess = MakeGuess(labels);
  const auto first =
    Segment<unsigned char>(tissue_test::MakeMembraneImage<unsigned char>(labels.GetPointer()), guess, 1);
  const auto second = Segment<float>(tissue_test::MakeMembraneImage<float>(labels.GetPointer()), guess, 4);
  EXPECT_EQ(tissue_test::Agreement<LabelImageType>(first, second), 1.0);
}

TEST(MembraneToTissueLabelImageFilter, WithoutAGuessTheMinimaAreTheCells)
{
  // 27 cubes; wide enough a margin for the exterior, and none.
  for (const long margin : { 18L, 0L })
  {
    const auto cubes = MakeCubes(9, margin);
    const auto segmented = Segment<float>(tissue_test::MakeMembraneImage<float>(cubes.GetPointer(), 10), nullptr);
    const auto found = LabelsOf(segmented);
    EXPECT_EQ(found.size(), margin > 0 ? 28u : 27u);
    EXPECT_EQ(*found.begin(), margin > 0 ? 0 : 1);
    EXPECT_EQ(*found.rbegin(), 27);
    std::set<std::pair<short, short>>                 pairs;
    double                                            numberOfSame = 0.0;
    itk::ImageRegionIteratorWithIndex<LabelImageType> it(cubes, cubes->GetLargestPossibleRegion());
    for (; !it.IsAtEnd(); ++it)
    {
      const short label = segmented->GetPixel(it.GetIndex());
      numberOfSame += (it.Get() == 0) == (label == 0) ? 1.0 : 0.0;
      const auto isMiddle = [&](int axis) { return (it.GetIndex()[axis] - margin) % 9 == 4; };
      if (it.Get() != 0 && isMiddle(0) && isMiddle(1) && isMiddle(2))
      {
        pairs.insert({ label, it.Get() });
      }
    }
    EXPECT_GE(numberOfSame / static_cast<double>(cubes->GetLargestPossibleRegion().GetNumberOfPixels()), 0.97);
    std::set<short> labelsOfMiddles;
    for (const auto & pair : pairs)
    {
      labelsOfMiddles.insert(pair.first);
    }
    EXPECT_EQ(labelsOfMiddles.size(), 27u);
    EXPECT_EQ(labelsOfMiddles.count(0), 0u);
  }
}

TEST(MembraneToTissueLabelImageFilter, DarkMembranesAreTheBrightOnesOfTheInverse)
{
  const auto bright = tissue_test::MakeMembraneImage<float>(MakeCubes(9, 18).GetPointer(), 10);
  const auto dark = tissue_test::MakeImage<float>({ { 63, 63, 63 } }, [&bright](long x, long y, long z) {
    return 255.0f - bright->GetPixel({ { x, y, z } });
  });
  const auto filter = itk::MembraneToTissueLabelImageFilter<MembraneImageType<float>, LabelImageType>::New();
  filter->SetInput(dark);
  filter->DarkMembranesOn();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfCells(), 27u);
  EXPECT_EQ(tissue_test::Agreement<LabelImageType>(filter->GetOutput(), Segment<float>(bright, nullptr)), 1.0);
}

TEST(MembraneToTissueLabelImageFilter, NoiseMakesNoCells)
{
  for (const double deviation : { 10.0, 30.0 })
  {
    const auto                       image = tissue_test::MakeMembraneImage<float>(MakeCubes(12, 18).GetPointer(), 0);
    std::mt19937                     random(4);
    std::normal_distribution<double> normal(0.0, deviation);
    for (float * pixel = image->GetBufferPointer(); pixel != image->GetBufferPointer() + 72 * 72 * 72; ++pixel)
    {
      *pixel += static_cast<float>(normal(random));
    }
    const auto filter = itk::MembraneToTissueLabelImageFilter<MembraneImageType<float>, LabelImageType>::New();
    filter->SetInput(image);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfCells(), 27u) << deviation;
    EXPECT_EQ(filter->GetOutput()->GetPixel({ { 0, 0, 0 } }), 0) << deviation;
    EXPECT_NEAR(filter->GetNoise() / deviation, 1.0, 0.1) << deviation;
    EXPECT_GT(filter->GetUsedDepth(), 0.015) << deviation;
    filter->SetNoiseDepth(0.0);
    filter->Update();
    EXPECT_GE(filter->GetNumberOfCells(), deviation > 20.0 ? 40u : 27u) << deviation;
    EXPECT_EQ(filter->GetUsedDepth(), 0.015) << deviation;
  }
}

TEST(MembraneToTissueLabelImageFilter, SaysWhatItCannotUse)
{
  const auto labels = MakeTissue();
  const auto guess = MakeGuess(labels);
  const auto membrane = tissue_test::MakeMembraneImage<float>(labels.GetPointer());
  membrane->SetPixel({ { 3, 4, 5 } }, std::numeric_limits<float>::quiet_NaN());
  EXPECT_NE(ErrorOf<float>(membrane, guess).find("The pixel at index [3, 4, 5] is nan"), std::string::npos)
    << ErrorOf<float>(membrane, guess);
  membrane->FillBuffer(7.0f);
  EXPECT_NE(ErrorOf<float>(membrane, nullptr).find("All pixels of the image are 7"), std::string::npos);

  const auto aside = tissue_test::MakeMembraneImage<float>(labels.GetPointer());
  aside->SetOrigin(itk::Point<double, 3>(std::array<double, 3>{ { 500.0, 0.0, 0.0 } }.data()));
  EXPECT_NE(ErrorOf<float>(aside, guess).find("cells have no voxel in the membrane image, label "), std::string::npos);

  using SmallImageType = itk::Image<signed char, 3>;
  const auto noise = tissue_test::MakeNoise<unsigned char>({ { 30, 30, 30 } }, 200, 5);
  const auto filter = itk::MembraneToTissueLabelImageFilter<itk::Image<unsigned char, 3>, SmallImageType>::New();
  filter->SetInput(noise);
  filter->SetMinimumDepth(0.0);
  filter->SetNoiseDepth(0.0);
  filter->SetMarkerSigma(0.1);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}
