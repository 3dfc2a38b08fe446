/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "itkCellCoreImageFilter.h"

#include <gtest/gtest.h>

namespace
{
using ImageType = itk::Image<short, 3>;
using FilterType = itk::CellCoreImageFilter<ImageType>;

/** Cells 70, 30 and -5 beside one another along x, of 20, 20 and 1 voxels, in a wide exterior of label 9. */
ImageType::Pointer
MakeRow()
{
  return tissue_test::MakeImage<short>({ { 60, 40, 40 } }, [](long x, long y, long z) {
    const bool isInside = x >= 10 && x < 51 && y >= 10 && y < 30 && z >= 10 && z < 30;
    return !isInside ? 9 : x < 30 ? 70 : x < 50 ? 30 : -5;
  });
}

FilterType::Pointer
MarkCores(ImageType * image)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->SetExteriorLabel(9);
  filter->Update();
  return filter;
}
} // namespace

TEST(CellCoreImageFilter, MarksTheInnerPartOfEveryCellAndTheDepthOfTheExterior)
{
  const auto image = MakeRow();
  const auto filter = MarkCores(image);
  const auto at = [&](long x, long y, long z) { return filter->GetOutput()->GetPixel({ { x, y, z } }); };
  EXPECT_EQ(filter->GetLabels(), (std::vector<tissue::Label>{ 70, 30, -5 }));
  // Depths of 0 ... 9 from the side to the middle: the core begins at 5.
  EXPECT_EQ(at(19, 20, 20), 2u);
  EXPECT_EQ(at(14, 20, 20), 0u);
  EXPECT_EQ(at(15, 20, 20), 2u);
  EXPECT_EQ(at(24, 20, 20), 2u);
  EXPECT_EQ(at(25, 20, 20), 0u);
  EXPECT_EQ(at(40, 20, 20), 3u);
  // A cell of one voxel's thickness is all core.
  EXPECT_EQ(at(50, 20, 20), 4u);
  EXPECT_EQ(at(50, 10, 10), 4u);
  // The mean cell of 5467 voxels has a diameter of 21.9 voxels, four tenths of which are 8.7.
  EXPECT_EQ(at(9, 20, 20), 0u);
  EXPECT_EQ(at(1, 20, 20), 0u);
  EXPECT_EQ(at(0, 20, 20), 1u);
  EXPECT_EQ(at(0, 0, 0), 1u);
}

TEST(CellCoreImageFilter, MeasuresInPhysicalUnits)
{
  const auto image = MakeRow();
  image->SetSpacing(itk::Vector<double, 3>(std::array<double, 3>{ { 1.0, 1.0, 4.0 } }.data()));
  const auto filter = MarkCores(image);
  const auto at = [&](long x, long y, long z) { return filter->GetOutput()->GetPixel({ { x, y, z } }); };
  // From the faces of z the second voxel is 4 deep, the third 8.
  EXPECT_EQ(at(19, 20, 10), 0u);
  EXPECT_EQ(at(19, 20, 11), 0u);
  EXPECT_EQ(at(19, 20, 12), 2u);
}

TEST(CellCoreImageFilter, BorderOfTheImageBoundsNothing)
{
  const auto image = tissue_test::MakeImage<short>({ { 20, 8, 8 } }, [](long x, long, long) { return x < 10 ? 1 : 2; });
  const auto filter = MarkCores(image);
  EXPECT_EQ(filter->GetOutput()->GetPixel({ { 0, 0, 0 } }), 2u);
  EXPECT_EQ(filter->GetOutput()->GetPixel({ { 19, 7, 7 } }), 3u);
  EXPECT_EQ(filter->GetOutput()->GetPixel({ { 9, 4, 4 } }), 0u);
}

TEST(CellCoreImageFilter, RefusesAnImageWithoutCells)
{
  const auto filter = FilterType::New();
  filter->SetInput(tissue_test::MakeImage<short>({ { 4, 4, 4 } }, [](long, long, long) { return 9; }));
  filter->SetExteriorLabel(9);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}
