/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "SyntheticTestTissue.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "itkCommand.h"
#include "itkJunctionsToCellWallMeshFilter.h"
#include "itkLabelJunctionExtractionFilter.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{
using ExtractionType = itk::LabelJunctionExtractionFilter<itk::Image<unsigned char, 3>>;

ExtractionType::Pointer
MakeExtraction()
{
  const auto extraction = ExtractionType::New();
  extraction->SetInput(MakeSyntheticTestTissue<unsigned char>());
  return extraction;
}

/** Whose walls are the fitted stars, which takes less time than to remesh them. */
itk::JunctionsToCellWallMeshFilter::Pointer
MakeFittingFilter(ExtractionType * extraction)
{
  const auto filter = itk::JunctionsToCellWallMeshFilter::New();
  filter->SetInput(extraction->GetOutput());
  filter->SetLabelVolume(extraction->GetLabelVolume());
  filter->SetRefinement(0);
  return filter;
}

itk::TissueJunctions::Pointer
MakeJunctions()
{
  const auto extraction = MakeExtraction();
  extraction->Update();
  return extraction->GetOutput();
}

/** Cells without walls, of these centres. */
itk::TissueJunctions::Pointer
MakeCells(const std::vector<tissue::Point> & centers)
{
  tissue::JunctionSet junctions;
  junctions.cells.resize(centers.size() + 1);
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    junctions.cells[i + 1].label = static_cast<tissue::Label>(i + 1);
    junctions.cells[i + 1].center = centers[i];
  }
  const auto object = itk::TissueJunctions::New();
  object->SetJunctionSet(junctions);
  return object;
}

/** The description of the exception of an update. */
std::string
RefusalOf(const itk::TissueJunctions *                                      junctions,
          const std::function<void(itk::JunctionsToCellWallMeshFilter *)> & change = nullptr)
{
  const auto filter = itk::JunctionsToCellWallMeshFilter::New();
  filter->SetInput(junctions);
  filter->UsePaperPreset();
  if (change)
  {
    change(filter);
  }
  try
  {
    filter->Update();
  }
  catch (const itk::ExceptionObject & error)
  {
    return error.GetDescription();
  }
  return "accepted";
}
} // namespace

TEST(JunctionsToCellWallMeshFilter, FewOrCoplanarCellsAreRefusedByTheirNumber)
{
  const std::vector<tissue::Point> square{ { { 0, 0, 1 } }, { { 1, 0, 1 } }, { { 1, 1, 1 } }, { { 0, 1, 1 } } };
  EXPECT_NE(RefusalOf(MakeCells({ square[0], square[1], square[2] })).find("3 cells, at least 4 are needed"),
            std::string::npos);
  EXPECT_NE(RefusalOf(MakeCells(square)).find("all 4 cell centres are coplanar"), std::string::npos);
}

TEST(JunctionsToCellWallMeshFilter, ParametersOutOfRangeAreRefusedByNameValueAndRange)
{
  using Filter = itk::JunctionsToCellWallMeshFilter;
  const auto                                                    junctions = MakeJunctions();
  const std::vector<std::pair<std::string, void (*)(Filter *)>> cases{
    { "refinement is 4, must be in 0 .. 3", [](Filter * filter) { filter->SetRefinement(4); } },
    { "refinement is -1, must be in 0 .. 3", [](Filter * filter) { filter->SetRefinement(-1); } },
    { "numberOfCycles is 1001, must be in 0 .. 1000", [](Filter * filter) { filter->SetNumberOfCycles(1001); } },
    { "smoothingIterations is -1, must be in 0", [](Filter * filter) { filter->SetSmoothingIterations(-1); } },
    { "maximumEdgeLength is -2, must be in 0", [](Filter * filter) { filter->SetMaximumEdgeLength(-2.0); } },
  };
  for (const auto & [message, change] : cases)
  {
    EXPECT_NE(RefusalOf(junctions, change).find(message), std::string::npos) << RefusalOf(junctions, change);
  }
}

TEST(JunctionsToCellWallMeshFilter, ProgressAscendsToOneAndTheFilterCanBeAborted)
{
  const auto filter = itk::JunctionsToCellWallMeshFilter::New();
  filter->SetInput(MakeJunctions());
  filter->UsePaperPreset();
  std::vector<float>  progress;
  const unsigned long observer = filter->AddObserver(
    itk::ProgressEvent(), [&](const itk::EventObject &) { progress.push_back(filter->GetProgress()); });
  filter->Update();
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_FLOAT_EQ(progress.back(), 1.0f);
  filter->RemoveObserver(observer);
  filter->Modified();
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) { filter->AbortGenerateDataOn(); });
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}

TEST(JunctionsToCellWallMeshFilter, ParametersMakeTheFilterRunAgain)
{
  const auto filter = itk::JunctionsToCellWallMeshFilter::New();
  filter->SetInput(MakeJunctions());
  filter->UsePaperPreset();
  filter->SetRefinement(0);
  filter->Update();
  const auto numberOfTriangles = filter->GetOutput()->GetNumberOfTriangles();
  filter->SetRefinement(2);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfTriangles(), 16 * numberOfTriangles);
}

TEST(JunctionsToCellWallMeshFilter, FitsTheWallsToTheVolumeOfAnExtractionThatItUpdates)
{
  const auto extraction = MakeExtraction();
  extraction->GenerateLabelVolumeOn();
  const auto filter = MakeFittingFilter(extraction);
  EXPECT_EQ(filter->GetLabelVolume(), extraction->GetLabelVolume());
  filter->Update();
  EXPECT_TRUE(filter->GetOutput()->GetReconstruction().isFitted);
  filter->SetLabelVolume(nullptr);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject) << "the complex is taken from it";
}

TEST(JunctionsToCellWallMeshFilter, RefusesALabelVolumeThatIsEmptyWhereItIsNeeded)
{
  const auto extraction = MakeExtraction();
  const auto filter = MakeFittingFilter(extraction);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->UsePaperPreset();
  filter->Update();
  EXPECT_FALSE(filter->GetOutput()->GetReconstruction().isFitted);
}

TEST(JunctionsToCellWallMeshFilter, AVolumeThatWasReleasedIsMadeAgain)
{
  const auto extraction = MakeExtraction();
  extraction->GenerateLabelVolumeOn();
  extraction->GetLabelVolume()->ReleaseDataFlagOn();
  const auto filter = MakeFittingFilter(extraction);
  filter->Update();
  EXPECT_EQ(extraction->GetLabelVolume()->GetNumberOfVoxels(), 0u);
  const auto points = filter->GetOutput()->GetWallMesh().points;
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetWallMesh().points, points);
}

TEST(JunctionsToCellWallMeshFilter, BulkAccessorsHoldTheMesh)
{
  const auto filter = itk::JunctionsToCellWallMeshFilter::New();
  EXPECT_THROW(filter->GetOutput()->GetWallMesh(), itk::ExceptionObject) << "before the update";
  filter->SetInput(MakeJunctions());
  filter->UsePaperPreset();
  filter->Update();
  const itk::CellWallMesh * const mesh = filter->GetOutput();
  const tissue::WallMesh &        walls = mesh->GetWallMesh();
  const auto                      coordinates = mesh->GetPointCoordinates();
  const auto                      triangles = mesh->GetTriangles();
  const auto                      labels = mesh->GetTriangleLabels();
  ASSERT_EQ(coordinates->Size(), 3 * walls.points.size());
  ASSERT_EQ(triangles->Size(), 3 * walls.triangles.size());
  ASSERT_EQ(labels->Size(), 2 * walls.triangles.size());
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    const auto & cells = walls.walls[walls.wallOfTriangle[t]].cells;
    // The labels of the tissue are the indices of its cells.
    EXPECT_EQ(labels->ElementAt(2 * t), cells[0]);
    EXPECT_EQ(labels->ElementAt(2 * t + 1), cells[1]);
    EXPECT_EQ(triangles->ElementAt(3 * t + 1), static_cast<itk::IdentifierType>(walls.triangles[t][1]));
  }
  EXPECT_EQ(coordinates->ElementAt(5), walls.points[1][2]);
}
