/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelInput.h"
#include "TissueTessellationCore/Evaluation/WallMeshEvaluation.h"

#include <gtest/gtest.h>
#include <itkImageRegionIteratorWithIndex.h>

namespace
{
/** Two bricks of 10 x 20 x 20 voxels of 0.5 x 1 x 1 that share a side, and a third one of 20 x 20 x 10 on top. */
tissue::LabelImage::Pointer
MakeBricks()
{
  const auto                          image = tissue::LabelImage::New();
  tissue::LabelImage::SizeType        size = { { 20, 20, 30 } };
  const tissue::LabelImage::IndexType start = { { 0, 0, 0 } };
  image->SetRegions(tissue::LabelImage::RegionType(start, size));
  image->Allocate();
  const double spacing[3] = { 0.5, 1.0, 1.0 };
  image->SetSpacing(spacing);
  for (itk::ImageRegionIteratorWithIndex<tissue::LabelImage> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    const auto & index = it.GetIndex();
    it.Set(index[2] >= 20 ? 9 : index[0] < 10 ? 4 : 6);
  }
  return image;
}

/** The junction set by hand: every two of the cells and the exterior share a wall; all four meet at two places. */
tissue::JunctionSet
JunctionsOfBricks()
{
  tissue::JunctionSet junctions;
  junctions.cells.resize(4);
  const std::array<tissue::Label, 4> labels = { { 0, 4, 6, 9 } };
  const std::array<double, 4>        volumes = { { 0.0, 2000.0, 2000.0, 2000.0 } };
  for (tissue::VertexId v = 0; v < 4; ++v)
  {
    junctions.cells[v].label = labels[v];
    junctions.cells[v].volume = volumes[v];
    for (tissue::VertexId u = 0; u < v; ++u)
    {
      junctions.walls.emplace_back();
      junctions.walls.back().cells = { { u, v } };
    }
  }
  junctions.junctions.emplace_back();
  junctions.junctions.back().cells = { { 0, 1, 2, 3 } };
  return junctions;
}

class PeerMeshers : public ::testing::Test
{
protected:
  tissue::WallMeshEvaluation
  Evaluate(const tissue::PeerMesh & mesh) const
  {
    const auto evaluation =
      tissue::EvaluateTissueMesh(tissue::MakeWallMesh(mesh.boundaries), junctions, tissue::MakePeerVolume(cells));
    // The space of the mesh is that of the volume: half a voxel beside, a cell of 10 layers has 0.95.
    EXPECT_GT(evaluation.meanDice, 0.97);
    EXPECT_LT(evaluation.distance.InVoxels(evaluation.distance.mean), 0.6);
    return evaluation.mesh;
  }

  tissue::JunctionSet        junctions = JunctionsOfBricks();
  tissue::CellImage::Pointer cells = tissue::MakeCellImage(MakeBricks(), junctions.cells);
};
} // namespace

TEST_F(PeerMeshers, Mesh3KeepsThreeBricks)
{
  tissue::Mesh3Parameters parameters;
  parameters.facetSize = 4.0;
  const auto mesh = tissue::MeshByMesh3(cells, parameters);
  const auto evaluation = this->Evaluate(mesh);
  EXPECT_EQ(evaluation.numberOfTriangles, mesh.numberOfOutputTriangles);
  EXPECT_EQ(evaluation.numberOfSpheres, 3u);
  EXPECT_DOUBLE_EQ(evaluation.overlap.adjacency2, 1.0);
  EXPECT_LT(evaluation.meanVolumeError, 0.05);
}

TEST_F(PeerMeshers, LabelContoursCloseEachCellAndLeaveGapsBetweenThem)
{
  for (const auto method : { tissue::LabelContour::DiscreteMarchingCubes, tissue::LabelContour::DiscreteFlyingEdges })
  {
    const auto mesh = tissue::MeshByLabelContours(cells, 4, method);
    const auto evaluation = this->Evaluate(mesh);
    EXPECT_LT(evaluation.numberOfTriangles, mesh.numberOfOutputTriangles);
    EXPECT_EQ(evaluation.numberOfSpheres, 3u);
    EXPECT_DOUBLE_EQ(evaluation.overlap.adjacency2, 1.0);
    // A contour's point lies between two voxels, so it has two labels: no corner.
    EXPECT_EQ(evaluation.numberOfCorners, 0u);
    EXPECT_LT(evaluation.meanVolumeError, 0.05);
  }
}
