/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkCellWallMeshStatisticsCalculator.h"

#include "SyntheticTestTissue.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"
#include "itkLabelImageToCellWallMeshFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{
using ImageType = itk::Image<unsigned short, 3>;
using CalculatorType = itk::CellWallMeshStatisticsCalculator;

/** Of the synthetic tissue with a voxel of the first cell apart from it. */
CalculatorType::Pointer
Calculate()
{
  const auto image = MakeSyntheticTestTissue<unsigned short>();
  image->SetPixel({ { 0, 0, 0 } }, 1);
  const auto filter = itk::LabelImageToCellWallMeshFilter<ImageType>::New();
  filter->SetInput(image);
  filter->Update();
  const auto calculator = CalculatorType::New();
  calculator->SetMesh(filter->GetOutput());
  calculator->Compute();
  return calculator;
}

class CellWallMeshStatisticsCalculator : public ::testing::Test
{
protected:
  static void
  SetUpTestSuite()
  {
    s_Calculator = Calculate();
  }

  static void
  TearDownTestSuite()
  {
    s_Calculator = nullptr;
  }

  static std::vector<double>
  CellColumn(const std::string & name)
  {
    return s_Calculator->GetCellColumn(name)->CastToSTLConstContainer();
  }

  static std::vector<double>
  WallColumn(const std::string & name)
  {
    return s_Calculator->GetWallColumn(name)->CastToSTLConstContainer();
  }

  static CalculatorType::Pointer s_Calculator;
};

CalculatorType::Pointer CellWallMeshStatisticsCalculator::s_Calculator;
} // namespace

TEST_F(CellWallMeshStatisticsCalculator, HasARowForEveryCellAndNoneForTheExterior)
{
  std::vector<itk::IdentifierType> labels(40);
  std::iota(labels.begin(), labels.end(), 1);
  EXPECT_EQ(s_Calculator->GetCellLabels()->CastToSTLConstContainer(), labels);
  const auto names = s_Calculator->GetCellColumnNames();
  const auto types = s_Calculator->GetCellColumnTypes();
  ASSERT_EQ(names.size(), types.size());
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const bool isVector = names[i] == "MajorAxis" || names[i] == "MiddleAxis" || names[i] == "MinorAxis";
    EXPECT_EQ(CellColumn(names[i]).size(), isVector ? 120u : 40u) << names[i];
  }
  EXPECT_EQ(names.front(), "Label");
  EXPECT_EQ(types.front(), "int64");
  EXPECT_EQ(types[std::find(names.begin(), names.end(), "IsClosed") - names.begin()], "uint8");
  EXPECT_EQ(types[std::find(names.begin(), names.end(), "Layer") - names.begin()], "int32");
  EXPECT_EQ(types[std::find(names.begin(), names.end(), "Volume") - names.begin()], "float64");
}

TEST_F(CellWallMeshStatisticsCalculator, CellsHaveTheirVolumesAndAnEpidermis)
{
  const auto volumes = CellColumn("Volume");
  const auto inImage = CellColumn("ImageVolume");
  for (std::size_t row = 0; row < volumes.size(); ++row)
  {
    // A voxel of the first is apart, and lost.
    EXPECT_NEAR(volumes[row] / inImage[row], 1.0, 0.02) << row + 1;
  }
  const auto layers = CellColumn("Layer");
  EXPECT_GT(std::count(layers.begin(), layers.end(), 1.0), 10);
  EXPECT_GT(std::count(layers.begin(), layers.end(), 2.0), 0);
}

TEST_F(CellWallMeshStatisticsCalculator, WallsOfACellAddUpToItsSurface)
{
  const auto areas = WallColumn("Area");
  const auto labels = s_Calculator->GetWallLabels()->CastToSTLConstContainer();
  ASSERT_EQ(labels.size(), 2 * areas.size());
  EXPECT_EQ(areas.size(), s_Calculator->GetMesh()->GetWallMesh().walls.size());
  EXPECT_EQ(WallColumn("Normal").size(), 3 * areas.size());
  std::vector<double> sums(41, 0.0);
  for (std::size_t wall = 0; wall < areas.size(); ++wall)
  {
    sums[labels[2 * wall]] += areas[wall];
    sums[labels[2 * wall + 1]] += areas[wall];
  }
  const auto surfaces = CellColumn("SurfaceArea");
  for (std::size_t row = 0; row < surfaces.size(); ++row)
  {
    EXPECT_NEAR(sums[row + 1], surfaces[row], 1e-9 * surfaces[row]);
  }
  EXPECT_EQ(WallColumn("WallId").back() + 1, areas.size());
}

TEST_F(CellWallMeshStatisticsCalculator, RemarksAreThoseOfTheCells)
{
  const auto labels = s_Calculator->GetRemarkLabels()->CastToSTLConstContainer();
  const auto reasons = s_Calculator->GetRemarkReasons();
  const auto values = s_Calculator->GetRemarkValues()->CastToSTLConstContainer();
  const auto texts = s_Calculator->GetRemarkTexts();
  ASSERT_EQ(labels.size(), reasons.size());
  ASSERT_EQ(labels.size(), values.size());
  ASSERT_EQ(labels.size(), texts.size());
  const auto found = std::find(reasons.begin(), reasons.end(), "severalPieces") - reasons.begin();
  ASSERT_LT(static_cast<std::size_t>(found), reasons.size());
  EXPECT_EQ(labels[found], 1u);
  EXPECT_EQ(values[found], 1.0);
  EXPECT_FALSE(texts[found].empty());
}

TEST_F(CellWallMeshStatisticsCalculator, AnglesAreThoseThatTheMeshPromises)
{
  EXPECT_GE(s_Calculator->GetMinimumTriangleAngle(), 10.0);
  EXPECT_GE(s_Calculator->GetMinimumDihedralAngle(), 10.0);
  EXPECT_GT(s_Calculator->GetEdgeLengthRatio(), 1.0);
}

TEST_F(CellWallMeshStatisticsCalculator, TheMeshTellsItsWallsPointsAndFigures)
{
  const auto mesh = s_Calculator->GetMesh();
  EXPECT_EQ(mesh->GetExteriorLabel(), 0);
  const auto walls = mesh->GetTriangleWalls()->CastToSTLConstContainer();
  EXPECT_EQ(walls.size(), mesh->GetNumberOfTriangles());
  EXPECT_TRUE(std::is_sorted(walls.begin(), walls.end()));
  const auto cells = mesh->GetNumbersOfCellsAtPoints()->CastToSTLConstContainer();
  EXPECT_EQ(cells.size(), mesh->GetNumberOfPoints());
  EXPECT_EQ(*std::min_element(cells.begin(), cells.end()), 2u);
  EXPECT_EQ(*std::max_element(cells.begin(), cells.end()), 4u);
  EXPECT_EQ(mesh->GetNumberOfCrossings(), 0u);
  EXPECT_GE(mesh->GetAdjacency4OfNeighbors(), mesh->GetAdjacency4());
  EXPECT_EQ(mesh->GetNumberOfFalsePairs() + mesh->GetNumberOfMissingPairs() == 0, mesh->GetAdjacency2() == 1.0);
}

TEST_F(CellWallMeshStatisticsCalculator, RefusesWhatItDoesNotKnow)
{
  EXPECT_THROW(s_Calculator->GetCellColumn("Colour"), itk::ExceptionObject);
  EXPECT_THROW(s_Calculator->GetWallColumn("Volume"), itk::ExceptionObject);
  const auto calculator = CalculatorType::New();
  EXPECT_THROW(calculator->GetCellColumnNames(), itk::ExceptionObject);
  EXPECT_THROW(calculator->Compute(), itk::ExceptionObject);
  calculator->SetMesh(itk::CellWallMesh::New());
  EXPECT_THROW(calculator->Compute(), itk::ExceptionObject);
}
