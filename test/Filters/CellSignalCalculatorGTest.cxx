/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"
#include "itkCellSignalCalculator.h"
#include "itkJunctionsToCellWallMeshFilter.h"
#include "itkLabelStatisticsImageFilter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using LabelImageType = tissue_test::LabelImage<unsigned char>;
using SignalType = itk::Image<float, 3>;
using CalculatorType = itk::CellSignalCalculator<SignalType>;

/** A tissue in space: turned, its voxels longer in z, its origin somewhere. */
struct PlacedTissue
{
  LabelImageType::Pointer         labels = tissue_test::MakeFourCubes<unsigned char>();
  itk::TissueLabelVolume::Pointer volume;
  itk::CellWallMesh::Pointer      mesh;

  PlacedTissue()
  {
    const double spacing[] = { 0.5, 0.5, 1.0 };
    const double origin[] = { 3.0, -20.0, 7.0 };
    labels->SetSpacing(spacing);
    labels->SetOrigin(origin);
    LabelImageType::DirectionType direction;
    direction.Fill(0.0);
    direction[1][0] = 1.0;
    direction[0][1] = -1.0;
    direction[2][2] = 1.0;
    labels->SetDirection(direction);
    const auto extraction = itk::LabelJunctionExtractionFilter<LabelImageType>::New();
    extraction->SetInput(labels);
    extraction->GenerateLabelVolumeOn();
    const auto filter = itk::JunctionsToCellWallMeshFilter::New();
    filter->SetInput(extraction->GetOutput());
    filter->SetLabelVolume(extraction->GetLabelVolume());
    filter->SetRefinement(0);
    filter->Update();
    volume = extraction->GetLabelVolume();
    mesh = filter->GetOutput();
  }

  CalculatorType::Pointer
  MakeCalculator(const SignalType * signal) const
  {
    const auto calculator = CalculatorType::New();
    calculator->SetImage(signal);
    calculator->SetLabelVolume(volume);
    calculator->SetMesh(mesh);
    return calculator;
  }
};

/** On the grid of an image, made finer by `factor` along each axis and with more voxels around it, the value at each
 * position. */
template <typename TFunction>
SignalType::Pointer
MakeSignal(const LabelImageType * like, double factor, const TFunction & valueAt, itk::SizeValueType margin = 0)
{
  auto region = like->GetLargestPossibleRegion();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    region.SetSize(axis, static_cast<itk::SizeValueType>(std::lround(factor * region.GetSize(axis))));
  }
  region.PadByRadius(margin);
  const auto signal = SignalType::New();
  signal->CopyInformation(like);
  signal->SetSpacing(like->GetSpacing() * (1.0 / factor));
  signal->SetRegions(region);
  signal->Allocate();
  // The corner of the first voxel stays where it is.
  itk::ContinuousIndex<double, 3> first;
  first.Fill(-0.5 + 0.5 / factor);
  signal->SetOrigin(like->TransformContinuousIndexToPhysicalPoint<double, double>(first));
  itk::ImageRegionIteratorWithIndex<SignalType> it(signal, region);
  for (; !it.IsAtEnd(); ++it)
  {
    it.Set(static_cast<float>(valueAt(signal->TransformIndexToPhysicalPoint<double>(it.GetIndex()))));
  }
  return signal;
}

using PointType = SignalType::PointType;

double
Ramp(const PointType & point)
{
  return 2.0 + point[0] + 0.5 * point[1] - 0.25 * point[2];
}
} // namespace

TEST(CellSignalCalculator, OnTheGridOfTheLabelsItAgreesWithLabelStatistics)
{
  const PlacedTissue tissue;
  const auto signal = MakeSignal(tissue.labels, 1.0, [](const PointType & p) { return std::sin(p[0] * p[1]) * p[2]; });
  const auto calculator = tissue.MakeCalculator(signal);
  calculator->Compute();
  const auto statistics = itk::LabelStatisticsImageFilter<SignalType, LabelImageType>::New();
  statistics->SetInput(signal);
  statistics->SetLabelInput(tissue.labels);
  statistics->Update();
  for (int v = 1; v <= 4; ++v)
  {
    const tissue::CellSignal & cell = calculator->GetCellSignals()[v];
    EXPECT_NEAR(statistics->GetMean(10 * v), cell.mean, 1e-9);
    EXPECT_NEAR(statistics->GetSum(10 * v) * 0.25, cell.integral, 1e-9);
    EXPECT_DOUBLE_EQ(16.0, cell.knownVolume);
    EXPECT_EQ(calculator->GetMeans()->ElementAt(v - 1), cell.mean);
  }
  EXPECT_DOUBLE_EQ(std::sqrt(1.5), calculator->GetUsedWallDistance());
}

TEST(CellSignalCalculator, OnOtherGridsALinearSignalHasTheSameMeans)
{
  const PlacedTissue tissue;
  const auto         own = tissue.MakeCalculator(MakeSignal(tissue.labels, 1.0, Ramp));
  own->Compute();
  for (const double factor : { 3.0, 0.5 })
  {
    const auto calculator = tissue.MakeCalculator(MakeSignal(tissue.labels, factor, Ramp));
    calculator->Compute();
    for (int v = 1; v <= 4; ++v)
    {
      EXPECT_NEAR(own->GetCellSignals()[v].mean, calculator->GetCellSignals()[v].mean, 1e-4) << factor;
      EXPECT_NEAR(own->GetCellSignals()[v].integral, calculator->GetCellSignals()[v].integral, 1e-2) << factor;
    }
  }
}

TEST(CellSignalCalculator, AWallHasTheSignalInItsMiddle)
{
  const PlacedTissue tissue;
  // Walls of so few triangles reach over the border of the labels.
  const auto calculator = tissue.MakeCalculator(MakeSignal(tissue.labels, 1.0, Ramp, 20));
  calculator->Compute();
  const auto means = calculator->GetMeansOfWalls();
  const auto walls = tissue::MeasureWalls(tissue.mesh->GetWallMesh());
  ASSERT_EQ(walls.size(), means->Size());
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    EXPECT_NEAR(Ramp(PointType(walls[w].center.data())), means->ElementAt(w), 1e-5);
  }
}

TEST(CellSignalCalculator, WhatIsBesideTheImageIsNotKnown)
{
  const PlacedTissue tissue;
  // Half of the voxels in each cell are left where the image has half of the slices.
  const auto signal = MakeSignal(tissue.labels, 1.0, [](const PointType &) { return 3.0; });
  signal->SetRegions(SignalType::SizeType{ { 12, 12, 4 } });
  signal->Allocate();
  signal->FillBuffer(3.0f);
  const auto calculator = tissue.MakeCalculator(signal);
  calculator->Compute();
  EXPECT_DOUBLE_EQ(8.0, calculator->GetCellSignals()[1].knownVolume);
  EXPECT_DOUBLE_EQ(24.0, calculator->GetCellSignals()[1].integral);

  PointType far;
  far.Fill(1000.0);
  signal->SetOrigin(far);
  EXPECT_THROW(calculator->Compute(), itk::ExceptionObject);
  EXPECT_TRUE(calculator->GetCellSignals().empty());
}

TEST(CellSignalCalculator, TheNumberOfWorkUnitsDoesNotMatter)
{
  const PlacedTissue tissue;
  const auto         signal = MakeSignal(tissue.labels, 0.7, [](const PointType & p) { return std::exp(0.1 * p[0]); });
  const auto         calculator = tissue.MakeCalculator(signal);
  calculator->SetWallDistance(0.6);
  calculator->SetNumberOfWorkUnits(1);
  calculator->Compute();
  const auto cells = calculator->GetCellSignals();
  const auto walls = calculator->GetWallMeans();
  calculator->SetNumberOfWorkUnits(7);
  calculator->Compute();
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    EXPECT_EQ(cells[v].integral, calculator->GetCellSignals()[v].integral);
    EXPECT_EQ(cells[v].meanNearWalls, calculator->GetCellSignals()[v].meanNearWalls);
  }
  EXPECT_EQ(walls, calculator->GetWallMeans());
}

TEST(CellSignalCalculator, WhatIsMissingIsSaid)
{
  const PlacedTissue tissue;
  const auto         calculator = CalculatorType::New();
  EXPECT_THROW(calculator->Compute(), itk::ExceptionObject);
  calculator->SetImage(MakeSignal(tissue.labels, 1.0, Ramp));
  calculator->SetMesh(tissue.mesh);
  EXPECT_THROW(calculator->Compute(), itk::ExceptionObject);
  tissue::LabelVolume other;
  other.size = { { 1, 1, 1 } };
  other.vertices = { 1 };
  const auto volume = itk::TissueLabelVolume::New();
  volume->SetLabelVolume(std::make_shared<const tissue::LabelVolume>(other));
  calculator->SetLabelVolume(volume);
  EXPECT_THROW(calculator->Compute(), itk::ExceptionObject);
}
