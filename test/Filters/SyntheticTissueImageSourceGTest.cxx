/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "SyntheticTissueTestHelpers.h"
#include "itkImageRegionConstIteratorWithIndex.h"

#include <gtest/gtest.h>

#include <map>

namespace
{
using namespace tissue_test;
template <typename TImage>
std::map<typename TImage::PixelType, std::size_t>
CountLabels(itk::ImageSource<TImage> * source)
{
  std::map<typename TImage::PixelType, std::size_t> counts;
  for (const auto label : VoxelsOf(source))
  {
    ++counts[label];
  }
  return counts;
}

void
ExpectError(SourceType * source, const std::string & message)
{
  try
  {
    source->Update();
    ADD_FAILURE() << "no error: " << message;
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find(message), std::string::npos) << error.GetDescription();
  }
}
} // namespace

TEST(SyntheticTissueImageSource, BlockFillsTheImageButForTheMargin)
{
  const auto source = MakeSmallSource(Shape::Block, CellModel::Anisotropic);
  source->SetSmoothing(0);
  EXPECT_EQ(CountLabels<ImageType>(source)[0], 48u * 44u * 40u - 40u * 36u * 32u);
  source->SetMargin(0);
  EXPECT_EQ(CountLabels<ImageType>(source).count(0), 0u);
}

TEST(SyntheticTissueImageSource, FlowerIsConcaveAndTheDomeIsNot)
{
  // Half way from the axis to the corner of the box, between two sepals, at mid-height.
  const ImageType::IndexType between = { { 24 + 14, 22 + 13, 20 } };
  for (const Shape shape : { Shape::Dome, Shape::Flower })
  {
    const auto source = MakeSmallSource(shape, CellModel::Voronoi);
    source->SetMargin(0);
    source->Update();
    EXPECT_EQ(source->GetOutput()->GetPixel(between) == 0, shape == Shape::Flower);
    EXPECT_NE(source->GetOutput()->GetPixel({ { 24, 22, 20 } }), 0);
    EXPECT_NE(source->GetOutput()->GetPixel({ { 46, 22, 20 } }) == 0, shape == Shape::Flower);
  }
}

TEST(SyntheticTissueImageSource, OriginDirectionAndStartIndexChangeNoVoxel)
{
  const auto                plain = MakeSmallSource(Shape::Dome, CellModel::Anisotropic);
  const auto                moved = MakeSmallSource(Shape::Dome, CellModel::Anisotropic);
  const double              origin[] = { 5.0, -6.0, 7.0 };
  SourceType::DirectionType direction;
  direction.Fill(0.0);
  direction[0][1] = 1.0;
  direction[1][2] = 1.0;
  direction[2][0] = -1.0;
  moved->SetOrigin(origin);
  moved->SetDirection(direction);
  moved->SetStartIndex(ImageType::IndexType{ { -3, 40, 2 } });
  EXPECT_EQ(VoxelsOf<ImageType>(plain), VoxelsOf<ImageType>(moved));
  EXPECT_EQ(moved->GetOutput()->GetDirection(), direction);
  EXPECT_EQ(moved->GetOutput()->GetOrigin()[2], 7.0);
}

TEST(SyntheticTissueImageSource, CellsAreEvenInPhysicalUnits)
{
  auto         source = MakeSmallSource(Shape::Block, CellModel::Voronoi);
  const double spacing[] = { 0.5, 0.5, 2.0 };
  source->SetSize(ImageType::SizeType{ { 72, 72, 18 } });
  source->SetSpacing(spacing);
  source->SetMargin(0);
  source->Update();
  // Means over the cells of the variance along each axis, in squared physical units.
  const tissue::JunctionSet junctions = Extract<ImageType>(source->GetOutput());
  std::array<double, 3>     variance = { { 0.0, 0.0, 0.0 } };
  for (itk::ImageRegionConstIteratorWithIndex<ImageType> it(source->GetOutput(),
                                                            source->GetOutput()->GetLargestPossibleRegion());
       !it.IsAtEnd();
       ++it)
  {
    const tissue::Point & center = junctions.cells[it.Get()].center;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double difference = it.GetIndex()[i] * spacing[i] - center[i];
      variance[i] += difference * difference;
    }
  }
  EXPECT_NEAR(variance[0] / variance[1], 1.0, 0.15);
  EXPECT_NEAR(variance[2] / variance[0], 1.0, 0.15);
}

TEST(SyntheticTissueImageSource, LabelsSkipTheExterior)
{
  using SignedImageType = itk::Image<signed char, 3>;
  auto source = itk::SyntheticTissueImageSource<SignedImageType>::New();
  source->SetSize(SignedImageType::SizeType{ { 32, 32, 32 } });
  source->SetNumberOfCells(10);
  source->SetFirstCellLabel(-4);
  source->SetExteriorLabel(2);
  const auto counts = CountLabels<SignedImageType>(source);
  ASSERT_EQ(counts.size(), 11u);
  EXPECT_EQ(counts.begin()->first, -4);
  EXPECT_EQ(counts.rbegin()->first, 6) << "-4 ... 1 and 3 ... 6";
  EXPECT_GT(counts.at(2), 32u * 32u * 4u);
  source->SetFirstCellLabel(118);
  source->SetExteriorLabel(117);
  EXPECT_EQ(CountLabels<SignedImageType>(source).rbegin()->first, 127);
  source->SetExteriorLabel(120);
  EXPECT_THROW(source->Update(), itk::ExceptionObject);
}

TEST(SyntheticTissueImageSource, SmoothingLeavesFewerVoxelFacesBetweenCells)
{
  std::array<std::int64_t, 2> faces = { { 0, 0 } };
  for (const unsigned int smoothing : { 0, 1 })
  {
    const auto source = MakeSmallSource(Shape::Dome, CellModel::Anisotropic);
    source->SetSmoothing(2 * smoothing);
    source->Update();
    for (const tissue::Wall & wall : Extract<ImageType>(source->GetOutput()).walls)
    {
      faces[smoothing] += wall.numberOfFaces;
    }
  }
  EXPECT_LT(faces[1], faces[0]);
}

TEST(SyntheticTissueImageSource, FewOrTinyCellsWork)
{
  const auto source = MakeSmallSource(Shape::Block, CellModel::Division);
  source->SetNumberOfCells(1);
  EXPECT_EQ(CountLabels<ImageType>(source).size(), 2u);
  source->SetSize(ImageType::SizeType{ { 30, 30, 30 } });
  source->SetMargin(0);
  source->SetNumberOfCells(1000);
  source->SetSmoothing(0);
  for (const CellModel model : { CellModel::Voronoi, CellModel::Anisotropic, CellModel::Division })
  {
    source->SetCellModel(model);
    EXPECT_EQ(CountLabels<ImageType>(source).size(), 1000u) << "27 voxels each: " << model;
  }
}

TEST(SyntheticTissueImageSource, RefusesWhatCannotBe)
{
  const auto make = [] { return MakeSmallSource(Shape::Block, CellModel::Anisotropic); };
  auto       source = make();
  source->SetNumberOfCells(0);
  ExpectError(source, "NumberOfCells is 0");
  source = make();
  source->SetNumberOfCells(1707); // 40 x 36 x 32 voxels are enough for 1706.
  ExpectError(source, "the Block has only 46080 voxels in this image, enough for 1706 cells of 27 voxels");
  source = make();
  source->SetMargin(20);
  ExpectError(source, "Margin of 20");
  source = make();
  source->SetAnisotropy(0.9);
  ExpectError(source, "Anisotropy is 0.9");
  source = make();
  source->SetFirstCellLabel(65500);
  ExpectError(source,
              "60 cells, from 65500 on without the exterior's, exceed the pixel type's greatest value of 65535");
  source = make();
  const double spacing[] = { 1.0, -1.0, 1.0 };
  source->SetSpacing(spacing);
  ExpectError(source, "Spacing is [1, -1, 1]");
}

TEST(SyntheticTissueImageSource, ReportsProgressAndStopsWhenAsked)
{
  for (const float stopAt : { 2.0f, 0.02f, 0.2f, 0.5f, 0.8f })
  {
    const auto source = MakeSmallSource(Shape::Dome, CellModel::Division);
    float      last = 0.0f;
    source->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
      EXPECT_GE(source->GetProgress(), last - 1e-5f);
      last = source->GetProgress();
      source->SetAbortGenerateData(last >= stopAt);
    });
    if (stopAt > 1.0f)
    {
      EXPECT_NO_THROW(source->Update());
      EXPECT_NEAR(last, 1.0f, 1e-5f);
    }
    else
    {
      EXPECT_THROW(source->Update(), itk::ProcessAborted);
      // Events come from the calling thread alone, on its share of the work.
      EXPECT_LT(last, stopAt + 0.3f);
    }
  }
}
