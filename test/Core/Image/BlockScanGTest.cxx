/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Image/BlockScan.h"

#include "VoxelTissue.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>

using namespace tissue_test;

namespace
{
using Sum = std::array<std::int64_t, 3>;

VoxelImage
TwoVoxels()
{
  return { { { 2, 1, 1 } }, [](int x, int, int) { return Label{ x == 0 ? 7 : 5 }; } };
}

BlockScan
ScanAll(const VoxelImage & image)
{
  return ScanPlanes(image, 1, image.size[2] + 2);
}

template <typename TTable>
const typename TTable::Entry *
Find(const TTable & table, const typename TTable::Key & key)
{
  for (const auto & entry : table.GetEntries())
  {
    if (entry.key == key)
    {
      return &entry;
    }
  }
  return nullptr;
}

void
ExpectFaces(const BlockScan::Faces & faces, std::int64_t number, const Sum & sum)
{
  EXPECT_EQ(faces.numberOfFaces, number);
  EXPECT_EQ(faces.sum, sum);
}
} // namespace

TEST(BlockScan, NumbersCellsInTheOrderTheyAreMet)
{
  EXPECT_EQ(ScanAll(TwoVoxels()).GetLabels().GetLabels(), (std::vector<Label>{ 0, 7, 5 }));
}

TEST(BlockScan, SumsTheFacesOfAWallByTheVoxelsAtTheirUpperSides)
{
  const BlockScan scan = ScanAll(TwoVoxels());
  // The voxels are at (1, 1, 1) and (2, 1, 1).
  const auto * const between = Find(scan.GetWalls(), { { 1, 2 } });
  ASSERT_NE(between, nullptr);
  ExpectFaces(between->value[0], 1, { { 2, 1, 1 } });
  ExpectFaces(between->value[1], 0, { { 0, 0, 0 } });
  ExpectFaces(between->value[2], 0, { { 0, 0, 0 } });
  const auto * const outside = Find(scan.GetWalls(), { { 0, 1 } });
  ASSERT_NE(outside, nullptr);
  ExpectFaces(outside->value[0], 1, { { 1, 1, 1 } });
  ExpectFaces(outside->value[1], 2, { { 2, 3, 2 } });
  ExpectFaces(outside->value[2], 2, { { 2, 2, 3 } });
  EXPECT_EQ(scan.GetWalls().GetEntries().size(), 3u);
}

TEST(BlockScan, TripleLinesAreTheBlocksOfThreeCells)
{
  const BlockScan scan = ScanAll(TwoVoxels());
  // The four corners of the face between the two voxels.
  ASSERT_EQ(scan.GetTriples().GetEntries().size(), 1u);
  EXPECT_EQ(scan.GetTriples().GetEntries()[0].key, (VertexTriple{ { 0, 1, 2 } }));
  EXPECT_EQ(scan.GetTriples().GetEntries()[0].value, 4);
  EXPECT_TRUE(scan.GetQuadruples().empty());
  EXPECT_EQ(scan.GetNumberOfCrowdedBlocks(), 0);
}

TEST(BlockScan, QuadruplesKnowTheirCornersAndWhetherAFifthCellIsThere)
{
  const BlockScan scan = ScanAll(FourColumns());
  // The padded corner of the line x = y = 4 is (5, 5); its ends at z = 3 and 7 see the exterior too.
  EXPECT_EQ(scan.GetNumberOfCrowdedBlocks(), 2);
  std::vector<std::int32_t> exact;
  std::vector<std::int32_t> crowded;
  for (const BlockScan::Quadruple & quadruple : scan.GetQuadruples())
  {
    EXPECT_EQ(quadruple.corner[0], 5);
    EXPECT_EQ(quadruple.corner[1], 5);
    if (quadruple.cells == VertexQuadruple{ { 1, 2, 3, 4 } })
    {
      (quadruple.exact ? exact : crowded).push_back(quadruple.corner[2]);
    }
    else
    {
      EXPECT_FALSE(quadruple.exact);
    }
  }
  EXPECT_EQ(exact, (std::vector<std::int32_t>{ 4, 5, 6 }));
  EXPECT_EQ(crowded, (std::vector<std::int32_t>{ 3, 7 }));
  EXPECT_EQ(scan.GetQuadruples().size(), 3u + 2u * 5u) << "five cells have five subsets of four";
}

TEST(BlockScan, DoesNotCountThePlaneBeforeItsFirst)
{
  // A column of three voxels, each a cell; the scan of its last plane and the one after it.
  const VoxelImage image{ { { 1, 1, 3 } }, [](int, int, int z) { return Label{ 10 + z }; } };
  const BlockScan  scan = ScanPlanes(image, 3, 5);
  EXPECT_EQ(scan.GetLabels().GetLabels(), (std::vector<Label>{ 0, 11, 12 }));
  const auto * const between = Find(scan.GetWalls(), { { 1, 2 } });
  ASSERT_NE(between, nullptr);
  ExpectFaces(between->value[2], 1, { { 1, 1, 3 } });
  EXPECT_EQ(Find(scan.GetWalls(), { { 0, 1 } }), nullptr) << "its sides are in the plane that is not counted";
  std::int64_t voxels = 0;
  for (const BlockScan::Piece & piece : scan.GetPieces())
  {
    voxels += piece.cell == ExteriorVertex ? 0 : piece.numberOfVoxels;
  }
  EXPECT_EQ(voxels, 1);
  // The runs of that plane have the first pieces: three rows, of which the middle one has the cell between two runs.
  ASSERT_GE(scan.GetPieces().size(), 5u);
  EXPECT_EQ(scan.GetPieces()[2].cell, 1);
}

TEST(BlockScan, JoinsThePiecesThatShareAFaceAlone)
{
  // One cell: a U of five voxels, and a voxel that touches it by an edge.
  const std::vector<std::string> rows{ "a.a.", "aaa.", "...a" };
  const VoxelImage image{ { { 4, 3, 1 } }, [&rows](int x, int y, int) { return Label{ rows[y][x] == 'a' ? 1 : 0 }; } };
  const BlockScan  scan = ScanAll(image);
  DisjointSets     sets = scan.GetPieceSets();
  std::map<std::int64_t, std::int64_t> voxels;
  for (std::size_t i = 0; i < scan.GetPieces().size(); ++i)
  {
    if (scan.GetPieces()[i].cell == 1)
    {
      voxels[sets.Find(static_cast<std::int64_t>(i))] += scan.GetPieces()[i].numberOfVoxels;
    }
  }
  ASSERT_EQ(voxels.size(), 2u);
  EXPECT_EQ(voxels.begin()->second, 5);
  EXPECT_EQ(voxels.rbegin()->second, 1);
}

TEST(BlockScan, MarksTheCellsWithAVoxelOnTheBorder)
{
  // A cell in the middle, one at each of the six sides, and the exterior elsewhere.
  const auto labelAt = [](int x, int y, int z) {
    const int steps = std::abs(x - 1) + std::abs(y - 1) + std::abs(z - 1);
    return Label{ steps == 0 ? 1 : steps == 1 ? 2 + x + 3 * y + 9 * z : 0 };
  };
  const VoxelImage image{ { { 3, 3, 3 } }, labelAt };
  const BlockScan  scan = ScanAll(image);
  const auto &     labels = scan.GetLabels().GetLabels();
  const auto &     touches = scan.GetTouchesBorder();
  ASSERT_EQ(labels.size(), 8u);
  for (std::size_t i = 1; i < labels.size(); ++i)
  {
    EXPECT_EQ(i < touches.size() && touches[i], labels[i] != 1) << "label " << labels[i];
  }
}

TEST(BlockScan, NeighbouringRunsOfOneCellAreOne)
{
  const ExteriorLabels exterior{ true, 0, false };
  BlockScan            scan({ { 3, 1, 1 } }, 1, exterior);
  for (int plane = 0; plane < 3; ++plane)
  {
    scan.BeginPlane();
    scan.EndRow();
    for (int x = 2; plane == 1 && x < 5; ++x)
    {
      scan.AddRun(9, x);
    }
    scan.EndRow();
    scan.EndRow();
  }
  const auto * const wall = Find(scan.GetWalls(), { { 0, 1 } });
  ASSERT_NE(wall, nullptr);
  ExpectFaces(wall->value[0], 2, { { 1 + 4, 2, 2 } });
  ExpectFaces(wall->value[1], 6, { { 12, 9, 6 } });
  EXPECT_EQ(scan.GetWalls().GetEntries().size(), 1u);
}
