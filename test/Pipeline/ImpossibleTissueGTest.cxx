/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "itkLabelImageToCellWallMeshFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

// Tissues that no simplicial complex with one exterior vertex can express.

namespace
{
using ImageType = tissue_test::LabelImage<unsigned short>;
using tissue::Remark;

itk::CellWallMesh::Pointer
Reconstruct(const ImageType * image, bool paperPreset = false)
{
  const auto filter = itk::LabelImageToCellWallMeshFilter<ImageType>::New();
  filter->SetInput(image);
  filter->SetExteriorLabel(0);
  if (paperPreset)
  {
    filter->UsePaperPreset();
  }
  filter->Update();
  return filter->GetOutput();
}

/** Every cell a closed sphere, at most four cells at a point. */
void
ExpectSound(const itk::CellWallMesh & mesh)
{
  const auto numberOfVertices = static_cast<tissue::VertexId>(mesh.GetNumberOfCells() + 1);
  const auto check = tissue::CheckCellSurfaces(mesh.GetWallMesh(), numberOfVertices);
  EXPECT_TRUE(check.cellsWithoutTriangles.empty());
  EXPECT_TRUE(check.cellsThatAreNoSphere.empty())
    << "Euler characteristic of the first: " << check.cells[check.cellsThatAreNoSphere.front()].eulerCharacteristic;
  EXPECT_TRUE(check.crowdedPoints.empty());
  EXPECT_EQ(check.numberOfMiscountedPoints, 0);
  EXPECT_EQ(check.numberOfUnusedPoints, 0);
}

std::set<tissue::Label>
LabelsWith(const itk::CellWallMesh & mesh, Remark remark)
{
  std::set<tissue::Label> labels;
  for (const tissue::CellRemark & r : mesh.GetReconstruction().remarks)
  {
    if (r.remark == remark)
    {
      labels.insert(mesh.GetJunctionSet().cells[r.cell].label);
    }
  }
  return labels;
}

/** The walls of the mesh: pairs of vertices, each as often as it has walls. */
std::multiset<tissue::VertexPair>
WallsOf(const itk::CellWallMesh & mesh)
{
  std::multiset<tissue::VertexPair> walls;
  for (const auto & wall : mesh.GetWallMesh().walls)
  {
    walls.insert({ { std::min(wall.cells[0], wall.cells[1]), std::max(wall.cells[0], wall.cells[1]) } });
  }
  return walls;
}

/** The nearest of the points of a spiral over the sphere, from 1. */
long
NearestOfSpiral(double x, double y, double z, int count)
{
  long   nearest = 0;
  double most = -2.0;
  for (int i = 0; i < count; ++i)
  {
    const double height = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = 2.399963 * i;
    const double radius = std::sqrt(1.0 - height * height);
    const double cosine =
      (x * radius * std::cos(angle) + y * radius * std::sin(angle) + z * height) / std::sqrt(x * x + y * y + z * z);
    if (cosine > most)
    {
      most = cosine;
      nearest = 1 + i;
    }
  }
  return nearest;
}

/** A shell of one layer of cells about the middle: `count` cells between the two radii, from the label given. */
long
ShellLabel(double x, double y, double z, double inner, double outer, int count, long first)
{
  const double radius = std::sqrt(x * x + y * y + z * z);
  return radius >= inner && radius <= outer ? first - 1 + NearestOfSpiral(x, y, z, count) : 0;
}

ImageType::Pointer
MakeShell()
{
  return tissue_test::MakeImage<unsigned short>({ { 52, 52, 52 } }, [](long x, long y, long z) {
    return ShellLabel(x - 25.3, y - 25.6, z - 25.1, 15.0, 23.0, 48, 1);
  });
}
} // namespace

TEST(ImpossibleTissue, HollowShellOfOneLayerIsNotFilledWithWalls)
{
  const auto image = MakeShell();
  const auto mesh = Reconstruct(image);
  ASSERT_EQ(mesh->GetNumberOfCells(), 48u);
  EXPECT_EQ(mesh->GetJunctionSet().cells[tissue::ExteriorVertex].numberOfPieces, 2) << "around and within";
  ExpectSound(*mesh);
  EXPECT_GT(mesh->GetAdjacency2(), 0.99);
  EXPECT_GT(mesh->GetAdjacency4(), 0.9);

  // Cells that meet in the image, if only at an edge of voxels.
  std::set<tissue::VertexPair> neighbors;
  for (const tissue::Junction & junction : mesh->GetJunctionSet().junctions)
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        neighbors.insert({ { junction.cells[i], junction.cells[j] } });
      }
    }
  }
  const auto walls = WallsOf(*mesh);
  const auto check = tissue::CheckCellSurfaces(mesh->GetWallMesh(), 49);
  for (tissue::VertexId v = 1; v <= 48; ++v)
  {
    EXPECT_EQ(walls.count({ { tissue::ExteriorVertex, v } }), 2u) << "cell " << v << " has an outer and an inner side";
    // A star of few triangles cuts the curved sides of a cell.
    EXPECT_NEAR(check.cells[v].volume / mesh->GetJunctionSet().cells[v].volume, 1.0, 0.3) << "cell " << v;
  }
  for (const tissue::VertexPair & wall : walls)
  {
    EXPECT_TRUE(wall[0] == tissue::ExteriorVertex || neighbors.count(wall)) << wall[0] << " " << wall[1];
  }
}

TEST(ImpossibleTissue, HollowShellInThePaperPresetHasOneExteriorAndIsSound)
{
  const auto mesh = Reconstruct(MakeShell(), true);
  ExpectSound(*mesh);
}

TEST(ImpossibleTissue, ShellInAShell)
{
  const auto image = tissue_test::MakeImage<unsigned short>({ { 70, 70, 70 } }, [](long x, long y, long z) {
    const long outer = ShellLabel(x - 34.3, y - 34.6, z - 34.1, 25.0, 32.0, 60, 1);
    return outer ? outer : ShellLabel(x - 34.3, y - 34.6, z - 34.1, 9.0, 17.0, 30, 101);
  });
  const auto mesh = Reconstruct(image);
  ASSERT_EQ(mesh->GetNumberOfCells(), 90u);
  EXPECT_EQ(mesh->GetJunctionSet().cells[tissue::ExteriorVertex].numberOfPieces, 3);
  ExpectSound(*mesh);
  const auto walls = WallsOf(*mesh);
  for (tissue::VertexId v = 1; v <= 90; ++v)
  {
    EXPECT_EQ(walls.count({ { tissue::ExteriorVertex, v } }), 2u) << "cell " << v;
  }
  for (const tissue::VertexPair & wall : walls)
  {
    EXPECT_TRUE(wall[0] == tissue::ExteriorVertex || (wall[0] <= 60) == (wall[1] <= 60)) << "between the shells";
  }
}

TEST(ImpossibleTissue, VoidWithinOneCellIsASecondWallOfItToTheExterior)
{
  const auto   image = tissue_test::MakeBallTissue<unsigned short>(40, 1);
  const auto   whole = Reconstruct(image);
  const auto   label = image->GetPixel({ { 20, 20, 20 } });
  const auto & cells = whole->GetJunctionSet().cells;
  const auto   cell =
    std::find_if(cells.begin() + 1, cells.end(), [label](const tissue::Cell & c) { return c.label == label; });
  ImageType::IndexType index;
  for (int i = 0; i < 3; ++i)
  {
    index[i] = std::lround(cell->center[i]);
  }
  ASSERT_EQ(image->GetPixel(index), label);
  image->SetPixel(index, 0);
  const auto mesh = Reconstruct(image);
  EXPECT_EQ(mesh->GetJunctionSet().cells[tissue::ExteriorVertex].numberOfPieces, 2);
  ExpectSound(*mesh);
  EXPECT_EQ(LabelsWith(*mesh, Remark::RingWalls).count(label), 1u);
  EXPECT_EQ(LabelsWith(*mesh, Remark::ExteriorLost).count(label), 0u);
}

TEST(ImpossibleTissue, TwoCellsThatShareTwoSeparateWalls)
{
  // Cells 1 and 2, one above the other, with the bar of cell 3 between them: it parts their wall. 4 to 7 are around.
  const auto image = tissue_test::MakeImage<unsigned short>({ { 24, 24, 20 } }, [](long x, long y, long z) {
    const bool isInside = x >= 7 && x < 17 && y >= 7 && y < 17 && z >= 4 && z < 16;
    if (isInside)
    {
      return std::abs(x - 11.5) < 2.0 && std::abs(z - 9.5) < 2.0 ? 3L : z < 10 ? 1L : 2L;
    }
    const bool isAround = x >= 2 && x < 22 && y >= 2 && y < 22 && z >= 2 && z < 18;
    return isAround ? 4L + (x >= 12) + 2L * (y >= 12) : 0L;
  });
  const auto mesh = Reconstruct(image);
  ASSERT_EQ(mesh->GetNumberOfCells(), 7u);
  ExpectSound(*mesh);
  EXPECT_EQ(WallsOf(*mesh).count({ { 1, 2 } }), 2u);
}

TEST(ImpossibleTissue, CellEnclosedInOneOther)
{
  const auto image = tissue_test::MakeBallTissue<unsigned short>(40, 2);
  const auto whole = Reconstruct(image);
  const auto label = image->GetPixel({ { 20, 20, 20 } });
  for (const tissue::Cell & cell : whole->GetJunctionSet().cells)
  {
    if (cell.label == label)
    {
      image->SetPixel({ { std::lround(cell.center[0]), std::lround(cell.center[1]), std::lround(cell.center[2]) } },
                      999);
    }
  }
  const auto mesh = Reconstruct(image);
  EXPECT_EQ(mesh->GetNumberOfCells(), whole->GetNumberOfCells() + 1);
  ExpectSound(*mesh);
  EXPECT_EQ(LabelsWith(*mesh, Remark::Enclosed), std::set<tissue::Label>{ 999 });
}

TEST(ImpossibleTissue, PiecesThatDoNotTouchHaveNoWallInCommon)
{
  const auto one = tissue_test::MakeBallTissue<unsigned short>(30, 3);
  const auto image = tissue_test::MakeImage<unsigned short>({ { 62, 30, 30 } }, [&one](long x, long y, long z) {
    const long label = x < 30 ? one->GetPixel({ { x, y, z } }) : x >= 32 ? one->GetPixel({ { x - 32, y, z } }) : 0;
    return label == 0 ? 0L : label + (x < 31 ? 0L : 200L);
  });
  const auto mesh = Reconstruct(image);
  ExpectSound(*mesh);
  const auto & cells = mesh->GetJunctionSet().cells;
  for (const tissue::VertexPair & wall : WallsOf(*mesh))
  {
    EXPECT_TRUE(wall[0] == tissue::ExteriorVertex || (cells[wall[0]].label < 200) == (cells[wall[1]].label < 200));
  }
}

TEST(ImpossibleTissue, CellsOfAnOpenSheetHaveTheirTwoSides)
{
  const auto image = tissue_test::MakeImage<unsigned short>({ { 60, 52, 20 } }, [](long x, long y, long z) {
    const long column = (x - 2 + (y / 8 % 2) * 4) / 8;
    const long floor = 5 + std::lround(2.0 * std::sin(0.1 * static_cast<double>(x + y)));
    return z >= floor && z < floor + 6 && x >= 2 && x < 58 && y >= 2 && y < 50 ? 1L + column + 10 * (y / 8) : 0L;
  });
  const auto mesh = Reconstruct(image);
  ExpectSound(*mesh);
  const auto       walls = WallsOf(*mesh);
  tissue::VertexId inTheMiddle = 0;
  for (tissue::VertexId v = 1; v <= static_cast<tissue::VertexId>(mesh->GetNumberOfCells()); ++v)
  {
    inTheMiddle += walls.count({ { tissue::ExteriorVertex, v } }) == 2u ? 1 : 0;
  }
  EXPECT_GT(inTheMiddle, static_cast<tissue::VertexId>(mesh->GetNumberOfCells()) / 3);
}
