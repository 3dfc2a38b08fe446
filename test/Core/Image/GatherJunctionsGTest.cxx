/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Image/GatherJunctions.h"
#include "VoxelTissue.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

using namespace tissue_test;

namespace
{
void
ExpectPoint(const Point & point, double x, double y, double z)
{
  EXPECT_NEAR(point[0], x, 1e-12);
  EXPECT_NEAR(point[1], y, 1e-12);
  EXPECT_NEAR(point[2], z, 1e-12);
}

/** A row of voxels, its labels the digits. */
VoxelImage
Row(const std::string & digits)
{
  return { { { static_cast<int>(digits.size()), 1, 1 } },
           [digits](int x, int, int) { return static_cast<Label>(digits[x] - '0'); } };
}

void
ExpectSame(const std::vector<Cell> & a, const std::vector<Cell> & b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_EQ(a[i].label, b[i].label);
    EXPECT_EQ(a[i].center, b[i].center);
    EXPECT_EQ(a[i].numberOfVoxels, b[i].numberOfVoxels);
    EXPECT_EQ(a[i].numberOfStrayVoxels, b[i].numberOfStrayVoxels);
    EXPECT_EQ(a[i].numberOfPieces, b[i].numberOfPieces);
    EXPECT_EQ(a[i].touchesExterior, b[i].touchesExterior);
    EXPECT_EQ(a[i].touchesBorder, b[i].touchesBorder);
  }
}

/** Whole tuples by the definition: the faces, and the blocks by their subsets of vertices. */
struct Definition
{
  std::map<std::set<Label>, std::int64_t> faces;
  std::map<std::set<Label>, std::int64_t> blocks;
  std::map<std::set<Label>, std::int64_t> exactBlocks;
  std::int64_t                            numberOfCrowdedBlocks = 0;

  explicit Definition(const VoxelImage & image)
  {
    const auto labelAt = [&image](const std::array<int, 3> & p) {
      bool isInside = true;
      for (int i = 0; i < 3; ++i)
      {
        isInside = isInside && p[i] >= 0 && p[i] < image.size[i];
      }
      return isInside ? image.labelAt(p[0], p[1], p[2]) : 0;
    };
    const int positions = (image.size[0] + 1) * (image.size[1] + 1) * (image.size[2] + 1);
    for (int i = 0; i < positions; ++i)
    {
      const std::array<int, 3> p{ { i % (image.size[0] + 1),
                                    i / (image.size[0] + 1) % (image.size[1] + 1),
                                    i / (image.size[0] + 1) / (image.size[1] + 1) } };
      std::set<Label>          block;
      for (int corner = 0; corner < 8; ++corner)
      {
        block.insert(labelAt({ { p[0] - corner % 2, p[1] - corner / 2 % 2, p[2] - corner / 4 } }));
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        std::array<int, 3> below = p;
        --below[axis];
        if (labelAt(below) != labelAt(p))
        {
          ++faces[{ labelAt(below), labelAt(p) }];
        }
      }
      this->CountSubsets(std::vector<Label>(block.begin(), block.end()));
    }
  }

private:
  void
  CountSubsets(const std::vector<Label> & block)
  {
    numberOfCrowdedBlocks += block.size() > 4;
    for (unsigned int bits = 0; bits < 1u << block.size(); ++bits)
    {
      std::set<Label> subset;
      for (std::size_t i = 0; i < block.size(); ++i)
      {
        if ((bits >> i & 1u) != 0)
        {
          subset.insert(block[i]);
        }
      }
      ++blocks[subset];
      exactBlocks[subset] += subset.size() == block.size();
    }
  }
};
} // namespace

TEST(GatherJunctions, MeasuresFourColumnsByHand)
{
  const JunctionSet set = JunctionsOf(FourColumns(), { { 2.0, 3.0, 5.0 } });
  ASSERT_EQ(set.cells.size(), 5u);
  EXPECT_EQ(set.cells[ExteriorVertex].numberOfVoxels, 512 - 64);
  for (int v = 1; v < 5; ++v)
  {
    EXPECT_EQ(set.cells[v].label, 10 * v);
    EXPECT_EQ(set.cells[v].numberOfVoxels, 16);
    EXPECT_DOUBLE_EQ(set.cells[v].volume, 16.0 * 30.0);
    EXPECT_TRUE(set.cells[v].touchesExterior);
    EXPECT_FALSE(set.cells[v].touchesBorder);
    ExpectPoint(set.cells[v].center, v % 2 == 1 ? 2.5 : 4.5, v <= 2 ? 2.5 : 4.5, 3.5);
  }
  ASSERT_EQ(set.walls.size(), 8u) << "opposite columns share an edge alone";
  const Wall * const wall = FindWall(set, { { 1, 2 } });
  ASSERT_NE(wall, nullptr);
  EXPECT_EQ(wall->numberOfFaces, 8);
  EXPECT_DOUBLE_EQ(wall->area, 8.0 * 15.0) << "faces normal to the first axis";
  ExpectPoint(wall->center, 3.5, 2.5, 3.5);
  const Wall * const outer = FindWall(set, { { 0, 1 } });
  ASSERT_NE(outer, nullptr);
  EXPECT_EQ(outer->numberOfFaces, 8 + 8 + 2 * 4);
  EXPECT_DOUBLE_EQ(outer->area, 8 * 15.0 + 8 * 10.0 + 2 * 4 * 6.0);
}

TEST(GatherJunctions, JunctionsLieAtTheMiddleOfTheirBlocks)
{
  const JunctionSet set = JunctionsOf(FourColumns());
  EXPECT_EQ(set.numberOfCrowdedBlocks, 2);
  ASSERT_EQ(set.junctions.size(), 5u);
  const Junction * const line = FindJunction(set, { { 1, 2, 3, 4 } });
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->numberOfBlocks, 5);
  EXPECT_EQ(line->numberOfExactBlocks, 3);
  EXPECT_EQ(line->numberOfClusters, 1);
  ExpectPoint(line->position, 3.5, 3.5, 3.5);
  // At both ends of the line, of which the first in raster order counts.
  const Junction * const ends = FindJunction(set, { { 0, 1, 2, 3 } });
  ASSERT_NE(ends, nullptr);
  EXPECT_EQ(ends->numberOfBlocks, 2);
  EXPECT_EQ(ends->numberOfExactBlocks, 0);
  EXPECT_EQ(ends->numberOfClusters, 2);
  ExpectPoint(ends->position, 3.5, 3.5, 1.5);
}

TEST(GatherJunctions, CountsFacesAndBlocksAsTheDefinitionDoes)
{
  // Label 0 is the exterior, and so a label is its vertex.
  const VoxelImage  image = Noise({ { 7, 5, 6 } }, 6);
  const Definition  expected(image);
  const JunctionSet set = JunctionsOf(image);
  std::size_t       triples = 0;
  std::size_t       quadruples = 0;
  for (const auto & blocks : expected.blocks)
  {
    triples += blocks.first.size() == 3;
    quadruples += blocks.first.size() == 4;
  }
  ASSERT_EQ(set.walls.size(), expected.faces.size());
  ASSERT_EQ(set.tripleLines.size(), triples);
  ASSERT_EQ(set.junctions.size(), quadruples);
  EXPECT_EQ(set.numberOfCrowdedBlocks, expected.numberOfCrowdedBlocks);
  EXPECT_GT(set.numberOfCrowdedBlocks, 0);
  for (const Wall & wall : set.walls)
  {
    EXPECT_EQ(wall.numberOfFaces, expected.faces.at({ wall.cells.begin(), wall.cells.end() }));
  }
  for (const TripleLine & line : set.tripleLines)
  {
    EXPECT_EQ(line.numberOfBlocks, expected.blocks.at({ line.cells.begin(), line.cells.end() }));
  }
  for (const Junction & junction : set.junctions)
  {
    const std::set<Label> cells(junction.cells.begin(), junction.cells.end());
    EXPECT_EQ(junction.numberOfBlocks, expected.blocks.at(cells));
    EXPECT_EQ(junction.numberOfExactBlocks, expected.exactBlocks.at(cells));
  }
}

TEST(GatherJunctions, ScansOfSomePlanesEachJoinedAreAsOneOfAll)
{
  for (const int labels : { 3, 6 })
  {
    const VoxelImage  image = Noise({ { 7, 5, 6 } }, labels);
    const JunctionSet whole = JunctionsOf(image);
    for (const std::vector<std::int32_t> & firstPlanes :
         { std::vector<std::int32_t>{ 1, 4 }, { 1, 2, 7 }, { 1, 2, 3, 4, 5, 6, 7 } })
    {
      const JunctionSet joined = JunctionsOf(image, { { 1, 1, 1 } }, firstPlanes);
      ExpectSame(joined.cells, whole.cells);
      ASSERT_EQ(joined.walls.size(), whole.walls.size());
      for (std::size_t i = 0; i < whole.walls.size(); ++i)
      {
        EXPECT_EQ(joined.walls[i].cells, whole.walls[i].cells);
        EXPECT_EQ(joined.walls[i].numberOfFaces, whole.walls[i].numberOfFaces);
        EXPECT_EQ(joined.walls[i].center, whole.walls[i].center);
      }
      ASSERT_EQ(joined.junctions.size(), whole.junctions.size());
      for (std::size_t i = 0; i < whole.junctions.size(); ++i)
      {
        EXPECT_EQ(joined.junctions[i].cells, whole.junctions[i].cells);
        EXPECT_EQ(joined.junctions[i].numberOfBlocks, whole.junctions[i].numberOfBlocks);
        EXPECT_EQ(joined.junctions[i].position, whole.junctions[i].position);
      }
      EXPECT_EQ(joined.numberOfCrowdedBlocks, whole.numberOfCrowdedBlocks);
    }
  }
}

TEST(GatherJunctions, CellsAscendByTheirLabelsInWhateverOrderTheyAreMet)
{
  const JunctionSet set = JunctionsOf(Row("7309"));
  ASSERT_EQ(set.cells.size(), 4u);
  EXPECT_EQ(set.cells[1].label, 3);
  EXPECT_EQ(set.cells[2].label, 7);
  EXPECT_EQ(set.cells[3].label, 9);
  ExpectPoint(set.cells[2].center, 0.0, 0.0, 0.0);
  EXPECT_EQ(FindWall(set, { { 1, 3 } }), nullptr) << "a voxel of the exterior lies between them";
}

TEST(GatherJunctions, OnlyTheLargestPieceGivesTheCentre)
{
  const JunctionSet set = JunctionsOf(Row("1122201"));
  EXPECT_EQ(set.cells[1].numberOfVoxels, 3);
  EXPECT_EQ(set.cells[1].numberOfPieces, 2);
  EXPECT_EQ(set.cells[1].numberOfStrayVoxels, 1);
  ExpectPoint(set.cells[1].center, 0.5, 0.0, 0.0);
  EXPECT_EQ(set.cells[2].numberOfPieces, 1);
  EXPECT_EQ(set.cells[2].numberOfStrayVoxels, 0);
}

TEST(GatherJunctions, WhereTheOutsideIsTheOnlyExteriorItHasALabelThatNoCellHas)
{
  VoxelImage image = Row("0123");
  image.exterior = { false, 0, true };
  EXPECT_EQ(JunctionsOf(image).cells[ExteriorVertex].label, -1);
  EXPECT_EQ(JunctionsOf(image).cells.size(), 5u);
  image.exterior = { true, 2, true };
  EXPECT_EQ(JunctionsOf(image).cells[ExteriorVertex].label, 2);
  EXPECT_EQ(JunctionsOf(image).cells.size(), 4u);
}

TEST(GatherJunctions, AVoidIsAPieceOfTheExteriorThatItsCellTouches)
{
  // A cube of label 1 around a voxel of the exterior.
  VoxelImage image{ { { 3, 3, 3 } }, [](int x, int y, int z) { return Label{ x * y * z == 1 ? 5 : 1 }; } };
  image.exterior = { true, 5, false };
  const JunctionSet set = JunctionsOf(image);
  ASSERT_EQ(set.cells.size(), 2u);
  EXPECT_EQ(set.cells[ExteriorVertex].numberOfPieces, 2);
  EXPECT_EQ(set.cells[ExteriorVertex].numberOfStrayVoxels, 1);
  EXPECT_TRUE(set.cells[1].touchesExterior);
  ASSERT_EQ(set.walls.size(), 1u);
  EXPECT_EQ(set.walls[0].numberOfFaces, 6 + 54);
}
