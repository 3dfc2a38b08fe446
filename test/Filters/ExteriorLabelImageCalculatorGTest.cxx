/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "itkExteriorLabelImageCalculator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using namespace tissue_test;
using ImageType = LabelImage<short>;
using FilterType = itk::LabelJunctionExtractionFilter<ImageType>;

/** Cubes of 4 voxels along each axis, labels from first on. */
long
CubeLabel(long x, long y, long z, long first)
{
  return first + x / 4 + 4 * (y / 4) + 16 * (z / 4);
}

/** 64 cubes of 4 voxels each, labels from 10 on, in a margin of 8 voxels of the label that `marginOf` gives a voxel. */
template <typename TMargin>
ImageType::Pointer
CubesInMargin(const TMargin & marginOf)
{
  return MakeImage<short>({ { 32, 32, 32 } }, [&](long x, long y, long z) {
    const bool isIn = std::min({ x, y, z }) >= 8 && std::max({ x, y, z }) < 24;
    return isIn ? CubeLabel(x - 8, y - 8, z - 8, 10) : static_cast<long>(marginOf(x, y, z));
  });
}

std::vector<tissue::Label>
GuessAll(const ImageType * image)
{
  const auto calculator = itk::ExteriorLabelImageCalculator<ImageType>::New();
  calculator->SetImage(image);
  calculator->Compute();
  return calculator->GetExteriorLabels();
}

struct Result
{
  bool has;
  long label;
};

Result
Guess(const ImageType * image, bool zeroIsCell = false)
{
  const auto calculator = itk::ExteriorLabelImageCalculator<ImageType>::New();
  calculator->SetImage(image);
  calculator->SetZeroIsCell(zeroIsCell);
  calculator->Compute();
  return { calculator->GetHasExteriorLabel(), static_cast<long>(calculator->GetExteriorLabel()) };
}
} // namespace

TEST(ExteriorLabelImageCalculator, FindsTheLabelAroundTheTissue)
{
  const Result result = Guess(MakeFourCubes<short>(7));
  EXPECT_TRUE(result.has);
  EXPECT_EQ(result.label, 7);
}

TEST(ExteriorLabelImageCalculator, LeavesABackgroundOfZero)
{
  EXPECT_FALSE(Guess(MakeFourCubes<short>(0)).has);
  EXPECT_FALSE(Guess(MakeBallTissue<short>(30, 1)).has);
}

TEST(ExteriorLabelImageCalculator, FindsNoneWhereEveryCellTouchesTheBorder)
{
  EXPECT_FALSE(
    Guess(MakeImage<short>({ { 16, 16, 8 } }, [](long x, long y, long z) { return CubeLabel(x, y, z, 1); })).has);
}

TEST(ExteriorLabelImageCalculator, FindsTheExteriorOfATissueCutByFiveSides)
{
  const Result result = Guess(
    MakeImage<short>({ { 16, 16, 16 } }, [](long x, long y, long z) { return z < 5 ? 1 : CubeLabel(x, y, z, 10); }));
  EXPECT_TRUE(result.has);
  EXPECT_EQ(result.label, 1);
}

TEST(ExteriorLabelImageCalculator, SeesTheExteriorThroughAPaddingOfZero)
{
  const auto   cubes = MakeFourCubes<short>(1);
  const Result result = Guess(MakeImage<short>({ { 20, 20, 20 } }, [&](long x, long y, long z) {
    const itk::Index<3> index = { { x - 4, y - 4, z - 4 } };
    return cubes->GetLargestPossibleRegion().IsInside(index) ? cubes->GetPixel(index) : 0;
  }));
  EXPECT_TRUE(result.has);
  EXPECT_EQ(result.label, 1);
}

TEST(ExteriorLabelImageCalculator, NeverTakesZeroWhereItIsACell)
{
  EXPECT_FALSE(Guess(MakeFourCubes<short>(0), true).has);
}

TEST(ExteriorLabelImageCalculator, FindsTheLabelOfMostOfTheBorderBesideAPocketOfBackground)
{
  // The pocket is seen by more than a fourth as many lines as the rest.
  const auto image = CubesInMargin([](long x, long y, long z) { return x + y + z < 30 ? 900 : 1; });
  EXPECT_EQ(GuessAll(image), std::vector<tissue::Label>{ 1 });
}

TEST(ExteriorLabelImageCalculator, FindsAllPartsOfABackgroundInParts)
{
  const auto image = CubesInMargin([](long, long, long z) { return z < 15 ? 500 : 501; });
  EXPECT_EQ(GuessAll(image), (std::vector<tissue::Label>{ 501, 500 }));
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().cells.size(), 65u);
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().exteriorLabels, (std::vector<tissue::Label>{ 0, 500, 501 }));
}

TEST(ExteriorLabelImageCalculator, TakesNoCellThatTheBorderCutsForTheExterior)
{
  // A large cell fills most of one side of a crop from within a tissue, and is no larger than its neighbours by far.
  const auto image = MakeImage<short>({ { 32, 32, 32 } }, [](long x, long y, long z) {
    const bool isLarge = z < 1 && std::min(x, y) >= 2 && std::max(x, y) < 30;
    return isLarge ? 5 : 10 + x / 8 + 4 * (y / 8) + 16 * (z / 8);
  });
  EXPECT_TRUE(GuessAll(image).empty());
}

TEST(ExteriorLabelImageCalculator, TakesNoCellAroundAnotherOneForTheExterior)
{
  const auto ballsOf = [](double outer, double inner) {
    return MakeImage<short>({ { 32, 32, 32 } }, [=](long x, long y, long z) {
      const double radius = std::hypot(x - 15.5, y - 15.5, z - 15.5);
      return radius < inner ? 2 : radius < outer ? 1 : 0;
    });
  };
  EXPECT_TRUE(GuessAll(ballsOf(12.0, 0.0)).empty());
  EXPECT_TRUE(GuessAll(ballsOf(12.0, 5.0)).empty());
}

TEST(LabelJunctionExtractionExterior, MayBeOfSeveralLabels)
{
  const auto image = CubesInMargin([](long x, long y, long z) { return x + y + z < 30 ? 900 : 1; });
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().cells.size(), 66u);
  filter->SetExteriorLabel(1);
  filter->AddExteriorLabel(900);
  filter->AddExteriorLabel(900);
  filter->Update();
  EXPECT_EQ(filter->GetUsedExteriorLabel(), 1);
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().cells.size(), 65u);
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().cells[0].numberOfPieces, 1);
  filter->AddExteriorLabel(901);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}

TEST(LabelJunctionExtractionExterior, TakesDroppedLabelsAndSuspects)
{
  const auto image = CubesInMargin([](long x, long y, long z) { return x + y + z < 30 ? 900 : 1; });
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->AddDroppedLabel(10);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().cells.size(), 65u);
  EXPECT_EQ(filter->GetUsedDroppedLabels(), std::vector<tissue::Label>{ 10 });
  EXPECT_EQ(filter->GetUsedExteriorLabel(), 1);
  filter->DropSuspectsOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().cells.size(), 64u);
  EXPECT_EQ(filter->GetUsedDroppedLabels(), (std::vector<tissue::Label>{ 10, 900 }));
  filter->ClearDroppedLabels();
  filter->Update();
  EXPECT_EQ(filter->GetUsedDroppedLabels(), std::vector<tissue::Label>{ 900 });
  filter->AddDroppedLabel(7);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}

TEST(LabelJunctionExtractionExterior, ZeroJoinsTheExteriorUnlessItIsACell)
{
  const auto image = MakeFourCubes<short>(1);
  image->SetPixel({ { 3, 3, 3 } }, 0);
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->Update();
  EXPECT_EQ(filter->GetUsedExteriorLabel(), 1);
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().cells.size(), 5u);
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().cells[0].numberOfPieces, 2);

  filter->ZeroIsCellOn();
  filter->Update();
  const auto & cells = filter->GetOutput()->GetJunctionSet().cells;
  ASSERT_EQ(cells.size(), 6u);
  EXPECT_EQ(cells[0].label, 1);
  EXPECT_EQ(cells[1].label, 0);
  EXPECT_EQ(cells[1].numberOfVoxels, 1);
}

// Where each label is a cell, 0 among them, the outside of the image is the exterior and has a label of its own.
TEST(LabelJunctionExtractionExterior, MayBeTheOutsideAlone)
{
  const auto filter = FilterType::New();
  filter->SetInput(MakeImage<short>({ { 16, 16, 8 } }, [](long x, long y, long z) { return CubeLabel(x, y, z, -1); }));
  filter->ZeroIsCellOn();
  filter->Update();
  const auto & set = filter->GetOutput()->GetJunctionSet();
  EXPECT_EQ(set.cells.size(), 1u + 32u);
  EXPECT_EQ(filter->GetUsedExteriorLabel(), -2);
  EXPECT_EQ(set.cells[0].numberOfVoxels, 0);
  EXPECT_EQ(set.walls[0].cells[0], tissue::ExteriorVertex);
}

TEST(LabelJunctionExtractionExterior, IsTheLabelThatWasSet)
{
  const auto filter = FilterType::New();
  filter->SetInput(MakeImage<short>({ { 16, 16, 8 } }, [](long x, long y, long z) { return CubeLabel(x, y, z, 1); }));
  filter->SetExteriorLabel(6);
  EXPECT_FALSE(filter->GetAutomaticExteriorLabel());
  filter->Update();
  EXPECT_EQ(filter->GetUsedExteriorLabel(), 6);
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().cells.size(), 32u);
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().cells[0].numberOfVoxels, 64);
}
