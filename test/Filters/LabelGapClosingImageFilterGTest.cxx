/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "TissueTessellationCore/Adjacency/SeparatedCells.h"
#include "itkLabelGapClosingImageFilter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace tissue_test;
using ImageType = LabelImage<short>;
using FilterType = itk::LabelGapClosingImageFilter<ImageType>;

/** Four columns along z, labels 10, 20, 30 and 40, of 4x4 voxels, with a cross of background of the given width between
 * them, in a margin of 4 voxels in x and y. */
ImageType::Pointer
MakeColumns(long gap, int background = 0)
{
  const auto size = static_cast<itk::SizeValueType>(16 + gap);
  return MakeImage<short>({ { size, size, 8 } }, [gap, background](long x, long y, long) {
    const auto side = [gap](long i) { return i >= 4 && i < 8 ? 0 : (i >= 8 + gap && i < 12 + gap ? 1 : -1); };
    return side(x) < 0 || side(y) < 0 ? background : 10 + 10 * side(x) + 20 * side(y);
  });
}

FilterType::Pointer
Close(const ImageType * image, double gapWidth, unsigned int threads = 2)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->SetGapWidth(gapWidth);
  filter->SetNumberOfWorkUnits(threads);
  filter->Update();
  return filter;
}

void
ExpectSameImage(const ImageType * image, const ImageType * expected)
{
  itk::ImageRegionConstIteratorWithIndex<ImageType> it(image, image->GetLargestPossibleRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    ASSERT_EQ(it.Get(), expected->GetPixel(it.GetIndex())) << it.GetIndex();
  }
}
} // namespace

// Values derived by hand: the cross has 2 * 2 * 10 - 4 voxels in each of the 8 planes, and in its middle a voxel is
// one step along both x and y away from its cell.
TEST(LabelGapClosingImageFilter, FillsTheWallsWithTheNearestCells)
{
  const auto filter = Close(MakeColumns(2), 2.0);
  EXPECT_EQ(filter->GetNumberOfChangedVoxels(), 36u * 8u);
  EXPECT_DOUBLE_EQ(filter->GetLargestDistance(), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(filter->GetUsedGapWidth(), 2.0);
  const auto expected = MakeImage<short>({ { 18, 18, 8 } }, [](long x, long y, long) {
    const bool isInside = x >= 4 && x < 14 && y >= 4 && y < 14;
    return isInside ? 10 + 10 * (x >= 9) + 20 * (y >= 9) : 0;
  });
  ExpectSameImage(filter->GetOutput(), expected);
}

TEST(LabelGapClosingImageFilter, BackgroundMayBeAnotherLabel)
{
  const auto filter = FilterType::New();
  filter->SetInput(MakeColumns(2, 1));
  filter->SetBackgroundLabel(1);
  filter->SetGapWidth(2.0);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfChangedVoxels(), 36u * 8u);
}

TEST(LabelGapClosingImageFilter, LeavesWiderGaps)
{
  const auto image = MakeColumns(4);
  const auto filter = Close(image, 2.0);
  EXPECT_EQ(filter->GetNumberOfChangedVoxels(), 0u);
  EXPECT_DOUBLE_EQ(filter->GetLargestDistance(), 0.0);
  ExpectSameImage(filter->GetOutput(), image);
}

// All runs of background between cells are 2 long.
TEST(LabelGapClosingImageFilter, FindsTheGapWidth)
{
  const auto filter = Close(MakeColumns(2), 0.0);
  EXPECT_DOUBLE_EQ(filter->GetUsedGapWidth(), 4.0);
  const auto set = Extract(filter->GetOutput());
  EXPECT_EQ(set.walls.size(), 4u + 4u);
  EXPECT_TRUE(tissue::FindSeparatedCells(set).empty());
}

TEST(LabelGapClosingImageFilter, ChangesNothingWithoutGaps)
{
  const auto image = MakeFourCubes<short>();
  const auto filter = Close(image, 0.0);
  EXPECT_DOUBLE_EQ(filter->GetUsedGapWidth(), 0.0);
  EXPECT_EQ(filter->GetNumberOfChangedVoxels(), 0u);
  ExpectSameImage(filter->GetOutput(), image);
}

// Voxels of 0.25 x 2 x 1: the arms of the cross are 0.5 and 4 wide.
TEST(LabelGapClosingImageFilter, WidthIsInPhysicalUnits)
{
  const auto   image = MakeColumns(2);
  const double spacing[3] = { 0.25, 2.0, 1.0 };
  image->SetSpacing(spacing);
  const auto narrow = Close(image, 1.0);
  EXPECT_EQ(narrow->GetOutput()->GetPixel({ { 8, 6, 4 } }), 10);
  EXPECT_EQ(narrow->GetOutput()->GetPixel({ { 6, 8, 4 } }), 0);
  const auto wide = Close(image, 4.0);
  EXPECT_EQ(wide->GetOutput()->GetPixel({ { 8, 6, 4 } }), 10);
  EXPECT_EQ(wide->GetOutput()->GetPixel({ { 6, 8, 4 } }), 10);
}

TEST(LabelGapClosingImageFilter, SmallerLabelWinsATie)
{
  const auto image =
    MakeImage<short>({ { 7, 5, 5 } }, [](long x, long, long) { return x < 3 ? 40 : (x > 3 ? 10 : 0); });
  EXPECT_EQ(Close(image, 1.0)->GetOutput()->GetPixel({ { 3, 2, 2 } }), 10);
}

// The middle of a void of 3x3x3 voxels is 2 from the nearest cell, that of 9x9x9 voxels 5.
TEST(LabelGapClosingImageFilter, FillsNarrowVoidsOnly)
{
  for (const long radius : { 1L, 4L })
  {
    const auto image = MakeImage<short>({ { 24, 24, 24 } }, [radius](long x, long y, long z) {
      const auto distance = std::max(std::max(std::abs(x - 12), std::abs(y - 12)), std::abs(z - 12));
      return distance <= radius ? 0 : 1 + (x >= 12) + 2 * (y >= 12) + 4 * (z >= 12);
    });
    const auto filter = Close(image, 2.0);
    EXPECT_EQ(filter->GetOutput()->GetPixel({ { 12, 12, 12 } }) == 0, radius > 1);
    if (radius == 1)
    {
      EXPECT_EQ(filter->GetNumberOfChangedVoxels(), 27u);
      EXPECT_DOUBLE_EQ(filter->GetLargestDistance(), 2.0);
    }
  }
}

TEST(LabelGapClosingImageFilter, SameForAnyNumberOfThreads)
{
  const auto image = MakeColumns(3);
  const auto one = Close(image, 4.0, 1);
  EXPECT_GT(one->GetNumberOfChangedVoxels(), 0u);
  for (const unsigned int threads : { 2u, 7u })
  {
    const auto filter = Close(image, 4.0, threads);
    EXPECT_EQ(filter->GetNumberOfChangedVoxels(), one->GetNumberOfChangedVoxels());
    ExpectSameImage(filter->GetOutput(), one->GetOutput());
  }
}

TEST(LabelGapClosingImageFilter, RefusesANegativeWidth)
{
  EXPECT_THROW(Close(MakeColumns(2), -1.0), itk::ExceptionObject);
}

TEST(SeparatedCells, AreThoseOfAnErodedSegmentation)
{
  EXPECT_EQ(tissue::FindSeparatedCells(Extract(MakeColumns(2).GetPointer())),
            (std::vector<tissue::VertexId>{ 1, 2, 3, 4 }));
  EXPECT_TRUE(tissue::FindSeparatedCells(Extract(MakeColumns(0).GetPointer())).empty());
}

// Balls of unit radius along x: 1 and 2 touch, 3 is at 2.9 from cell 2, and 4 is far from all.
TEST(SeparatedCells, AreNearAnotherCell)
{
  tissue::JunctionSet set;
  for (const double x : { 0.0, -2.0, 0.0, 2.9, 30.0 })
  {
    set.cells.emplace_back();
    set.cells.back().center = { { x, 0.0, 0.0 } };
    set.cells.back().volume = 4.0 / 3.0 * 3.14159265358979;
  }
  for (const tissue::VertexPair & cells : { tissue::VertexPair{ { 0, 3 } }, tissue::VertexPair{ { 1, 2 } } })
  {
    set.walls.emplace_back();
    set.walls.back().cells = cells;
  }
  EXPECT_EQ(tissue::FindSeparatedCells(set), (std::vector<tissue::VertexId>{ 3 }));
  EXPECT_TRUE(tissue::FindSeparatedCells(set, 1.0).empty());
}
