/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// The whole pipeline on real meristems, which are no part of the project: skipped where they are absent.
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "itkLabelImageToCellWallMeshFilter.h"

#include <gtest/gtest.h>
#include <itkImageFileReader.h>
#include <itkMetaImageIO.h>

#include <filesystem>

namespace
{
using ImageType = itk::Image<unsigned short, 3>;

class RealTissue : public testing::TestWithParam<const char *>
{
protected:
  void
  SetUp() override
  {
    m_Path = std::filesystem::path(REAL_TISSUE_FOLDER) / (std::string(GetParam()) + "-labels.mha");
    if (!std::filesystem::exists(m_Path))
    {
      GTEST_SKIP() << "There is no " << m_Path;
    }
  }

  std::filesystem::path m_Path;
};
} // namespace

TEST_P(RealTissue, ReachesTheAgreementOfThePaperAndBeyond)
{
  const auto reader = itk::ImageFileReader<ImageType>::New();
  reader->SetImageIO(itk::MetaImageIO::New());
  reader->SetFileName(m_Path.string());
  const auto filter = itk::LabelImageToCellWallMeshFilter<ImageType>::New();
  filter->SetInput(reader->GetOutput());
  const auto expectSoundMesh = [&filter] {
    const itk::CellWallMesh & mesh = *filter->GetOutput();
    const auto                check =
      tissue::CheckCellSurfaces(mesh.GetWallMesh(), static_cast<tissue::VertexId>(mesh.GetNumberOfCells() + 1));
    EXPECT_TRUE(check.cellsWithoutTriangles.empty());
    // Three cells of p194-t2 have a handle in the image.
    EXPECT_LE(check.cellsThatAreNoSphere.size(), 3u);
    for (std::size_t v = tissue::ExteriorVertex + 1; v < check.cells.size(); ++v)
    {
      EXPECT_TRUE(check.cells[v].IsClosed()) << v;
    }
    EXPECT_TRUE(check.crowdedPoints.empty());
  };
  filter->UsePaperPreset();
  filter->Update();
  EXPECT_GE(filter->GetOutput()->GetAdjacency4(), 0.70);
  expectSoundMesh();
  filter->UseDefaultPreset();
  filter->Update();
  EXPECT_GE(filter->GetOutput()->GetAdjacency4(), 0.88);
  expectSoundMesh();
}

INSTANTIATE_TEST_SUITE_P(Meristems, RealTissue, testing::Values("p60d2", "p194-t2", "sam", "stack100"),
                         [](const auto & information) {
                           std::string name = information.param;
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name;
                         });
