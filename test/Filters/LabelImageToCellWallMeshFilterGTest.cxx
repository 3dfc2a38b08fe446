/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "SyntheticTestTissue.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "itkCommand.h"
#include "itkJunctionsToCellWallMeshFilter.h"
#include "itkLabelImageToCellWallMeshFilter.h"
#include "itkLabelJunctionExtractionFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using ImageType = itk::Image<unsigned short, 3>;
using FilterType = itk::LabelImageToCellWallMeshFilter<ImageType>;

FilterType::Pointer
MakeFilter(const ImageType * image)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  return filter;
}

itk::CellWallMesh::Pointer
MakeMesh(const ImageType * image)
{
  const auto filter = MakeFilter(image);
  filter->Update();
  return filter->GetOutput();
}

void
ExpectClosedSpheres(const itk::CellWallMesh * mesh)
{
  const auto check =
    tissue::CheckCellSurfaces(mesh->GetWallMesh(), static_cast<tissue::VertexId>(mesh->GetNumberOfCells() + 1));
  EXPECT_TRUE(check.cellsWithoutTriangles.empty());
  EXPECT_TRUE(check.cellsThatAreNoSphere.empty());
  EXPECT_TRUE(check.crowdedPoints.empty()) << "points with more than four cells";
  EXPECT_EQ(check.numberOfMiscountedPoints, 0);
  EXPECT_EQ(check.numberOfUnusedPoints, 0);
}

/** Same tetrahedra, triangles and walls. */
void
ExpectSameTopology(const itk::CellWallMesh * mesh, const itk::CellWallMesh * expected)
{
  EXPECT_EQ(mesh->GetReconstruction().tetrahedra, expected->GetReconstruction().tetrahedra);
  EXPECT_EQ(mesh->GetWallMesh().triangles, expected->GetWallMesh().triangles);
  EXPECT_EQ(mesh->GetWallMesh().wallOfTriangle, expected->GetWallMesh().wallOfTriangle);
}
} // namespace

TEST(LabelImageToCellWallMeshFilter, EveryPresetGivesClosedSpheresWithAtMostFourCellsAtAPoint)
{
  const auto filter = MakeFilter(MakeSyntheticTestTissue<unsigned short>());
  filter->UsePaperPreset();
  filter->Update();
  ExpectClosedSpheres(filter->GetOutput());
  const double adjacencyOfPaper = filter->GetOutput()->GetAdjacency4();
  filter->UseDefaultPreset();
  filter->Update();
  ExpectClosedSpheres(filter->GetOutput());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 40u);
  EXPECT_GT(filter->GetOutput()->GetAdjacency4(), adjacencyOfPaper);
}

TEST(LabelImageToCellWallMeshFilter, RotatedAndShiftedImageGivesTheTransformedMesh)
{
  // Spacing is anisotropic; the axes of the image turn about (1, 2, 2) / 3 by 90 degrees, by Rodrigues' formula.
  ImageType::DirectionType rotation;
  const double             axis[] = { 1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0 };
  const double cross[3][3] = { { 0, -axis[2], axis[1] }, { axis[2], 0, -axis[0] }, { -axis[1], axis[0], 0 } };
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      rotation[i][j] = axis[i] * axis[j] + cross[i][j];
    }
  }
  const double shift[] = { -30.0, 7.0, 110.0 };
  const auto   image = MakeSyntheticTestTissue<unsigned short>();
  // The stars: how a wall is remeshed can depend on the last digit of its points.
  const auto makeStars = [&image]() -> itk::CellWallMesh::Pointer {
    const auto filter = MakeFilter(image);
    filter->SetRefinement(0);
    filter->Update();
    return filter->GetOutput();
  };
  const itk::CellWallMesh::Pointer expected = makeStars();
  image->SetDirection(rotation);
  image->SetOrigin(shift);
  image->Modified();
  const itk::CellWallMesh::Pointer mesh = makeStars();

  ExpectSameTopology(mesh, expected);
  std::vector<double> errors;
  for (std::size_t p = 0; p < expected->GetWallMesh().points.size(); ++p)
  {
    double largestError = 0.0;
    for (unsigned int i = 0; i < 3; ++i)
    {
      double coordinate = shift[i];
      for (unsigned int j = 0; j < 3; ++j)
      {
        coordinate += rotation[i][j] * expected->GetWallMesh().points[p][j];
      }
      largestError = std::max(largestError, std::abs(coordinate - mesh->GetWallMesh().points[p][i]));
    }
    errors.push_back(largestError);
  }
  // Points that were untangled went steps along the axes of space, and others follow them to the volumes of the cells.
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.01);
}

TEST(LabelImageToCellWallMeshFilter, VotesDecideWhichCellsMeet)
{
  const auto filter = MakeFilter(MakeSyntheticTestTissue<unsigned short>());
  filter->SetRefinement(0);
  filter->Update();
  const std::vector<tissue::VertexQuadruple> byImage = filter->GetOutput()->GetReconstruction().tetrahedra;
  // For what the image has, but for a tenth of it.
  std::vector<tissue::JunctionVote> list;
  for (std::size_t i = 0; i < byImage.size(); i += 1 + (i % 10 == 9))
  {
    list.push_back({ byImage[i], 1.0 });
    std::sort(list.back().cells.begin(), list.back().cells.end());
  }
  const auto votes = itk::TissueVotes::New();
  votes->SetVotes(list);
  filter->SetVotes(votes);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetJunctionSet().votes.size(), list.size());
  EXPECT_NE(filter->GetOutput()->GetReconstruction().tetrahedra, byImage);
  ExpectClosedSpheres(filter->GetOutput());
  filter->SetVotes(nullptr);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetReconstruction().tetrahedra, byImage);
}

TEST(LabelImageToCellWallMeshFilter, ScaledImageGivesTheScaledMesh)
{
  const auto image = MakeSyntheticTestTissue<unsigned short>();
  const auto expected = MakeMesh(image);
  image->SetSpacing(4.0 * image->GetSpacing());
  const auto mesh = MakeMesh(image);
  ExpectSameTopology(mesh, expected);
  double largestError = 0.0;
  for (std::size_t p = 0; p < expected->GetWallMesh().points.size(); ++p)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      largestError =
        std::max(largestError, std::abs(4.0 * expected->GetWallMesh().points[p][i] - mesh->GetWallMesh().points[p][i]));
    }
  }
  EXPECT_LT(largestError, 1e-9);
}

TEST(LabelImageToCellWallMeshFilter, ResultDoesNotDependOnTheThreads)
{
  const auto image = MakeSyntheticTestTissue<unsigned short>();
  const auto single = MakeFilter(image);
  single->SetNumberOfWorkUnits(1);
  single->Update();
  const auto several = MakeFilter(image);
  several->SetNumberOfWorkUnits(5);
  several->Update();
  ExpectSameTopology(several->GetOutput(), single->GetOutput());
  EXPECT_EQ(several->GetOutput()->GetWallMesh().points, single->GetOutput()->GetWallMesh().points);
}

TEST(LabelImageToCellWallMeshFilter, ProgressAscendsToOne)
{
  const auto         filter = MakeFilter(MakeSyntheticTestTissue<unsigned short>());
  std::vector<float> progress;
  filter->AddObserver(itk::ProgressEvent(),
                      [&](const itk::EventObject &) { progress.push_back(filter->GetProgress()); });
  filter->Update();
  ASSERT_GE(progress.size(), 10u);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_FLOAT_EQ(progress.back(), 1.0f);
}

TEST(LabelImageToCellWallMeshFilter, CanBeAbortedInEveryPhase)
{
  for (const float when : { 0.1f, 0.5f, 0.9f })
  {
    const auto filter = MakeFilter(MakeSyntheticTestTissue<unsigned short>());
    filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
      if (filter->GetProgress() > when)
      {
        filter->AbortGenerateDataOn();
      }
    });
    EXPECT_THROW(filter->Update(), itk::ProcessAborted) << when;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfTriangles(), 0u) << when;
  }
}

TEST(LabelImageToCellWallMeshFilter, AnAbortAtAnyEventLeavesItUsable)
{
  const auto  image = MakeSyntheticTestTissue<unsigned short>();
  const auto  whole = MakeFilter(image);
  std::size_t numberOfEvents = 0;
  whole->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) { ++numberOfEvents; });
  whole->Update();
  ASSERT_GT(numberOfEvents, 10u);

  const auto  filter = MakeFilter(image);
  std::size_t stopAt = 0;
  std::size_t event = 0;
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    if (++event == stopAt)
    {
      filter->AbortGenerateDataOn();
    }
  });
  constexpr std::size_t numberOfStops = 12;
  for (std::size_t stop = 0; stop < numberOfStops; ++stop)
  {
    event = 0;
    stopAt = 1 + stop * (numberOfEvents - 2) / (numberOfStops - 1);
    filter->Modified();
    EXPECT_THROW(filter->Update(), itk::ProcessAborted) << stopAt << " of " << numberOfEvents;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfTriangles(), 0u);
  }
  stopAt = 0;
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetWallMesh().points, whole->GetOutput()->GetWallMesh().points);
}

TEST(LabelImageToCellWallMeshFilter, TakesTheExteriorLabelGiven)
{
  const auto filter = MakeFilter(MakeSyntheticTestTissue<unsigned short>());
  filter->SetExteriorLabel(0);
  EXPECT_FALSE(filter->GetAutomaticExteriorLabel());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 40u);
  filter->SetExteriorLabel(41);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject) << "no voxel has this label";
  filter->AutomaticExteriorLabelOn();
  EXPECT_NO_THROW(filter->Update());
}

TEST(LabelImageToCellWallMeshFilter, IsTheTwoFiltersInOne)
{
  const auto image = MakeSyntheticTestTissue<unsigned short>();
  const auto extraction = itk::LabelJunctionExtractionFilter<ImageType>::New();
  extraction->SetInput(image);
  extraction->GenerateLabelVolumeOn();
  const auto reconstruction = itk::JunctionsToCellWallMeshFilter::New();
  reconstruction->SetInput(extraction->GetOutput());
  reconstruction->SetLabelVolume(extraction->GetLabelVolume());
  reconstruction->Update();
  const auto mesh = MakeMesh(image);
  EXPECT_TRUE(mesh->GetReconstruction().isFitted);
  ExpectSameTopology(mesh, reconstruction->GetOutput());
  EXPECT_EQ(mesh->GetWallMesh().points, reconstruction->GetOutput()->GetWallMesh().points);
}

TEST(LabelImageToCellWallMeshFilter, NeedsAnInput)
{
  EXPECT_THROW(FilterType::New()->Update(), itk::ExceptionObject);
}
