/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/WallRemeshing.h"
#include "SyntheticTestTissue.h"
#include "TissueTessellationCore/Geometry/TriangleQuality.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "itkLabelImageToCellWallMeshFilter.h"

#include <gtest/gtest.h>

TEST(RemeshedTissue, WallsOfAnImageReachTheQualityAtTheWantedNumberOfTriangles)
{
  using ImageType = itk::Image<unsigned short, 3>;
  const auto filter = itk::LabelImageToCellWallMeshFilter<ImageType>::New();
  filter->SetInput(MakeSyntheticTestTissue<unsigned short>());
  filter->SetRefinement(0);
  filter->SetSmoothingIterations(0);
  filter->Update();
  const auto numberOfCells = static_cast<tissue::VertexId>(filter->GetOutput()->GetNumberOfCells());

  tissue::WallMesh mesh = filter->GetOutput()->GetWallMesh();
  const double     wanted = 150.0 * numberOfCells;
  tissue::RemeshToNumberOfTriangles(mesh, wanted);
  EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), wanted, 0.03 * wanted);
  const tissue::QualitySummary quality = tissue::SummarizeTriangleQuality(mesh.points, mesh.triangles);
  EXPECT_GE(quality.mean, 0.92);
  EXPECT_GE(quality.fifthPercentile, 0.75);
  const tissue::CellSurfaceCheck check = tissue::CheckCellSurfaces(mesh, numberOfCells + 1);
  EXPECT_TRUE(check.cellsThatAreNoSphere.empty());
  EXPECT_TRUE(check.crowdedPoints.empty());
  EXPECT_EQ(check.numberOfMiscountedPoints, 0);
  EXPECT_EQ(check.numberOfUnusedPoints, 0);
}
