/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "itkExteriorLabelImageCalculator.h"

#include <gtest/gtest.h>

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
