/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "SyntheticTestTissue.h"
#include "itkPointSetToTissueLabelImageFilter.h"

#include <gtest/gtest.h>
#include <itkImage.h>
#include <itkImageRegionConstIterator.h>
#include <itkLabelImageToShapeLabelMapFilter.h>

namespace
{
using LabelImageType = itk::Image<std::uint16_t, 3>;
using PointSetType = itk::PointSet<double, 3>;
using FilterType = itk::PointSetToTissueLabelImageFilter<PointSetType, LabelImageType>;
using ShapesType = itk::LabelImageToShapeLabelMapFilter<LabelImageType>;

ShapesType::OutputImageType::Pointer
MeasureShapes(const LabelImageType * labels)
{
  const auto shapes = ShapesType::New();
  shapes->SetInput(labels);
  shapes->Update();
  return shapes->GetOutput();
}

/** The centroids of the cells of 1, 2, 3, ... */
PointSetType::Pointer
CentersOf(const LabelImageType * labels)
{
  const auto shapes = MeasureShapes(labels);
  const auto points = PointSetType::New();
  for (unsigned int i = 0; i < shapes->GetNumberOfLabelObjects(); ++i)
  {
    points->SetPoint(i, shapes->GetNthLabelObject(i)->GetCentroid());
  }
  return points;
}

PointSetType::Pointer
MakePoints(const std::vector<tissue::Point> & positions)
{
  const auto points = PointSetType::New();
  for (const tissue::Point & position : positions)
  {
    points->SetPoint(points->GetNumberOfPoints(), position.data());
  }
  return points;
}

LabelImageType::Pointer
MakeTissue(const PointSetType * points, const LabelImageType * reference, itk::ThreadIdType numberOfThreads = 2)
{
  const auto filter = FilterType::New();
  filter->SetInput(points);
  filter->SetReferenceImage(reference);
  filter->SetVoxelsPerCell(500);
  filter->SetNumberOfWorkUnits(numberOfThreads);
  filter->Update();
  return filter->GetOutput();
}

std::string
ErrorOf(const PointSetType * points, const LabelImageType * reference)
{
  try
  {
    MakeTissue(points, reference);
  }
  catch (const itk::ExceptionObject & error)
  {
    return error.GetDescription();
  }
  return "none";
}

/** Turns and moves the image in physical space. */
void
Place(LabelImageType * image)
{
  LabelImageType::DirectionType direction;
  direction.Fill(0.0);
  direction[0][1] = -0.6;
  direction[2][1] = 0.8;
  direction[0][2] = 0.8;
  direction[2][2] = 0.6;
  direction[1][0] = 1.0;
  image->SetDirection(direction);
  const double origin[] = { -7.0, 100.0, 3.0 };
  image->SetOrigin(origin);
}

std::size_t
CountDifferences(const LabelImageType * a, const LabelImageType * b)
{
  EXPECT_EQ(a->GetLargestPossibleRegion(), b->GetLargestPossibleRegion());
  itk::ImageRegionConstIterator<LabelImageType> itA(a, a->GetLargestPossibleRegion());
  itk::ImageRegionConstIterator<LabelImageType> itB(b, b->GetLargestPossibleRegion());
  std::size_t                                   count = 0;
  for (; !itA.IsAtEnd(); ++itA, ++itB)
  {
    count += itA.Get() != itB.Get() ? 1 : 0;
  }
  return count;
}
} // namespace

TEST(PointSetToTissueLabelImageFilter, EveryPointIsNearTheCentroidOfItsCell)
{
  const auto tissue = MakeSyntheticTestTissue<std::uint16_t>();
  const auto points = CentersOf(tissue);
  const auto shapes = MeasureShapes(MakeTissue(points, tissue));
  ASSERT_EQ(shapes->GetNumberOfLabelObjects(), 40u);
  const double diameter = std::cbrt(shapes->GetNthLabelObject(0)->GetPhysicalSize());
  double       sum = 0.0;
  for (unsigned int i = 0; i < 40; ++i)
  {
    sum += shapes->GetLabelObject(i + 1)->GetCentroid().EuclideanDistanceTo(points->GetPoint(i));
  }
  EXPECT_LT(sum / 40, 0.07 * diameter);
}

TEST(PointSetToTissueLabelImageFilter, FillsTheBoxOfTheReferenceWhereverItIs)
{
  const auto tissue = MakeSyntheticTestTissue<std::uint16_t>();
  const auto straight = MakeTissue(CentersOf(tissue), tissue);
  Place(tissue);
  const auto points = CentersOf(tissue);
  const auto turned = MakeTissue(points, tissue);
  EXPECT_EQ(turned->GetDirection(), tissue->GetDirection());
  // Rounding decides for voxels between two cells.
  EXPECT_LT(CountDifferences(straight, turned), turned->GetLargestPossibleRegion().GetNumberOfPixels() / 200);
  // The box's corners are at the same places.
  for (const double end : { 0.0, 1.0 })
  {
    itk::ContinuousIndex<double, 3> ofReference;
    itk::ContinuousIndex<double, 3> ofOutput;
    for (unsigned int i = 0; i < 3; ++i)
    {
      ofReference[i] = end * tissue->GetLargestPossibleRegion().GetSize(i) - 0.5;
      ofOutput[i] = end * turned->GetLargestPossibleRegion().GetSize(i) - 0.5;
    }
    itk::Point<double, 3> a;
    itk::Point<double, 3> b;
    tissue->TransformContinuousIndexToPhysicalPoint(ofReference, a);
    turned->TransformContinuousIndexToPhysicalPoint(ofOutput, b);
    EXPECT_LT(a.EuclideanDistanceTo(b), 1e-9);
  }
  for (unsigned int i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    LabelImageType::IndexType index;
    ASSERT_TRUE(turned->TransformPhysicalPointToIndex(points->GetPoint(i), index));
    EXPECT_NE(turned->GetPixel(index), 0) << i;
  }
}

TEST(PointSetToTissueLabelImageFilter, PadsTheBoxOfThePointsWithoutAReference)
{
  const auto tissue = MakeSyntheticTestTissue<std::uint16_t>();
  const auto labels = MakeTissue(CentersOf(tissue), nullptr);
  EXPECT_EQ(MeasureShapes(labels)->GetNumberOfLabelObjects(), 40u);
  const auto last = labels->GetLargestPossibleRegion().GetUpperIndex();
  for (itk::ImageRegionConstIterator<LabelImageType> it(labels, labels->GetLargestPossibleRegion()); !it.IsAtEnd();
       ++it)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      if (it.GetIndex()[i] == 0 || it.GetIndex()[i] == last[i])
      {
        ASSERT_EQ(it.Get(), 0) << it.GetIndex();
      }
    }
  }
}

TEST(PointSetToTissueLabelImageFilter, IsTheSameForAnyNumberOfThreads)
{
  const auto tissue = MakeSyntheticTestTissue<std::uint16_t>();
  const auto points = CentersOf(tissue);
  EXPECT_EQ(CountDifferences(MakeTissue(points, tissue, 1), MakeTissue(points, tissue, 2)), 0u);
}

TEST(PointSetToTissueLabelImageFilter, RefusesPointsThatMakeNoTissue)
{
  const auto tissue = MakeSyntheticTestTissue<std::uint16_t>();
  const auto errorWith = [&tissue](std::vector<tissue::Point> points) {
    for (const tissue::Point & p : { tissue::Point{ { 5, 5, 5 } }, { { 10, 5, 5 } }, { { 5, 10, 5 } } })
    {
      points.push_back(p);
    }
    return ErrorOf(MakePoints(points), tissue);
  };
  EXPECT_NE(ErrorOf(MakePoints({}), tissue).find("0 points, at least 4 are needed"), std::string::npos);
  EXPECT_NE(errorWith({}).find("3 points, at least 4 are needed"), std::string::npos);
  EXPECT_EQ(errorWith({ { { 10, 10, 5 } } }), "none") << "a layer of four cells";
  EXPECT_EQ(errorWith({ { { 8, 8, 10 } } }), "none");
  EXPECT_NE(
    errorWith({ { { 8, 8, 10 } }, { { 30, 8, 10 } } })
      .find("point 1 at [30, 8, 10] is outside of the box of the reference image, which has the size [40, 40, 18], the "
            "spacing [0.5, 0.5, 1] and the origin [0, 0, 0]"),
    std::string::npos);
  EXPECT_NE(errorWith({ { { 8, 8, 10 } }, { { 8, 8, 10 } } }).find("points 0 and 1 have the same place"),
            std::string::npos);
  EXPECT_NE(errorWith({ { { 8, 8, std::nan("") } } }).find("must be finite"), std::string::npos);
  EXPECT_NE(errorWith({ { { 8, 8, 2e30 } } }).find("point 0 has the coordinate 2e+30, must be finite and at most"),
            std::string::npos);
  EXPECT_EQ(ErrorOf(MakePoints({ { { 1, 1, 1 } }, { { 2, 2, 2 } }, { { 3, 3, 3 } }, { { 4, 4, 4 } } }), nullptr),
            "none");
  const tissue::Point same{ { 5, 5, 5 } };
  EXPECT_NE(ErrorOf(MakePoints({ same, same, same, same }), nullptr).find("extend over 0, must be 1e-30 at least"),
            std::string::npos);
}

TEST(PointSetToTissueLabelImageFilter, FindsLayersUnlessToldOtherwise)
{
  std::vector<tissue::Point> points;
  for (int i = 0; i < 25; ++i)
  {
    points.push_back({ { 2.0 * (i % 5), 2.0 * (i / 5), 0.1 * (i % 3) } });
  }
  const auto filter = FilterType::New();
  filter->SetInput(MakePoints(points));
  filter->SetVoxelsPerCell(500);
  EXPECT_EQ(filter->GetLayer(), FilterType::LayerEnum::Automatic);
  filter->Update();
  EXPECT_EQ(filter->GetVotes()->GetNumberOfVotes(), 0u);
  EXPECT_EQ(MeasureShapes(filter->GetOutput())->GetNumberOfLabelObjects(), points.size());
  filter->SetLayer(FilterType::LayerEnum::Off);
  filter->Update();
  EXPECT_GT(filter->GetVotes()->GetNumberOfVotes(), 0u);
  filter->SetLayer(FilterType::LayerEnum::On);
  filter->Update();
  EXPECT_EQ(filter->GetVotes()->GetNumberOfVotes(), 0u);
}

TEST(PointSetToTissueLabelImageFilter, RefusesMorePointsThanLabels)
{
  using SmallType = itk::Image<std::uint8_t, 3>;
  std::vector<tissue::Point> points;
  for (int i = 0; i < 255; ++i)
  {
    points.push_back({ { 1.0 * (i % 8), 1.0 * (i / 8 % 8), 1.0 * (i / 64) } });
  }
  const auto filter = itk::PointSetToTissueLabelImageFilter<PointSetType, SmallType>::New();
  filter->SetVoxelsPerCell(50);
  filter->SetInput(MakePoints(points));
  EXPECT_NO_THROW(filter->Update());
  points.push_back({ { 7, 7, 3 } });
  filter->SetInput(MakePoints(points));
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}
