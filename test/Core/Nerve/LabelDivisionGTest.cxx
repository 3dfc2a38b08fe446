/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/ImageTopology.h"

#include "Nerve/TestGeneralComplexes.h"
#include "Nerve/TestImages.h"

#include <gtest/gtest.h>

#include <set>

using namespace testing_nerve;

namespace
{
/** The pairs of an image's cells whose pieces are joined by an edge. */
std::set<VertexPair>
RealPairs(const ImageTopology & topology)
{
  std::set<VertexPair> pairs;
  for (const auto & edge : topology.nerve.complex.FindEdges())
  {
    const VertexId a = topology.cellOf[edge.vertices[0]];
    const VertexId b = topology.cellOf[edge.vertices[1]];
    if (a != b)
    {
      pairs.insert({ { std::min(a, b), std::max(a, b) } });
    }
  }
  return pairs;
}

/** That the complex has the image's pairs and no others, and every piece of a cell one sphere, without a repair.
 * Returns the number of pairs. */
std::size_t
ExpectExact(const LabelVolume & volume)
{
  const ImageTopology  topology = FindImageTopology(volume, NumberOfVertices(volume));
  std::set<VertexPair> pairs;
  for (const ImageWall & wall : FindImageWalls(volume))
  {
    pairs.insert(wall.cells);
  }
  EXPECT_EQ(RealPairs(topology), pairs);
  EXPECT_TRUE(topology.repairs.empty());
  EXPECT_TRUE(topology.unsoundCells.empty());
  EXPECT_EQ(FindViolations(topology.nerve.complex), std::vector<std::string>());
  std::int64_t pieces = 0;
  for (const DividedCell & cell : topology.divided)
  {
    EXPECT_EQ(cell.numberOfPieces, std::count(topology.cellOf.begin(), topology.cellOf.end(), cell.cell));
    pieces += cell.numberOfPieces - 1;
  }
  EXPECT_EQ(static_cast<std::int64_t>(topology.cellOf.size()), NumberOfVertices(volume) + pieces);
  return pairs.size();
}

/** Cells of 4 voxels' edge side by side along the first axis, in a margin of exterior. */
LabelVolume
Row(std::int32_t count, std::int32_t margin = 4)
{
  const std::int32_t across = 4 + 2 * margin;
  return MakeImage({ { 4 * count + 2 * margin, across, across } }, [=](std::int32_t x, std::int32_t y, std::int32_t z) {
    const auto isIn = [=](std::int32_t i, std::int32_t n) { return i >= margin && i < margin + n; };
    return isIn(x, 4 * count) && isIn(y, 4) && isIn(z, 4) ? VertexId{ 1 + (x - margin) / 4 } : ExteriorVertex;
  });
}

double
Radius(double x, double y, double z)
{
  return Norm({ { x, y, z } });
}
} // namespace

TEST(LabelDivision, OfSolidTissueIsNone)
{
  const LabelVolume volume = Bricks({ { 3, 3, 2 } }, 6);
  ExpectExact(volume);
  EXPECT_TRUE(FindImageTopology(volume, NumberOfVertices(volume)).divided.empty());
}

TEST(LabelDivision, GivesAlone)
{
  EXPECT_EQ(ExpectExact(Row(1)), 1u);
  EXPECT_EQ(ExpectExact(Row(2)), 3u);
  EXPECT_EQ(ExpectExact(Row(3)), 5u);
  EXPECT_EQ(ExpectExact(Row(8)), 15u);
}

TEST(LabelDivision, GivesWhatFillsTheImage)
{
  EXPECT_EQ(ExpectExact(Row(2, 0)), 3u);
}

TEST(LabelDivision, GivesARing)
{
  const LabelVolume volume = MakeImage({ { 40, 40, 12 } }, [](std::int32_t x, std::int32_t y, std::int32_t z) {
    const double r = Radius(x - 19.5, y - 19.5, 0.0);
    const double angle = std::atan2(y - 19.5, x - 19.5) + 3.1415926535;
    const bool   isIn = r > 10.0 && r < 16.0 && z > 2 && z < 9;
    return isIn ? 1 + std::min(VertexId{ 11 }, static_cast<VertexId>(angle / (2.0 * 3.1415926535) * 12.0))
                : ExteriorVertex;
  });
  EXPECT_EQ(ExpectExact(volume), 24u);
}

TEST(LabelDivision, GivesNestedCells)
{
  // A nucleus in the middle of a cell, and a group of two within a third.
  const LabelVolume volume =
    MakeImage({ { 44, 20, 20 } }, [](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
      if (Radius(x - 9.5, y - 9.5, z - 9.5) < 8.0)
      {
        return Radius(x - 9.5, y - 9.5, z - 9.5) < 3.0 ? 2 : 1;
      }
      if (Radius(x - 31.5, y - 9.5, z - 9.5) < 9.0)
      {
        return Radius(x - 31.5, y - 9.5, z - 9.5) < 4.0 ? (x < 32 ? 4 : 5) : 3;
      }
      return ExteriorVertex;
    });
  EXPECT_EQ(ExpectExact(volume), 6u);
}

TEST(LabelDivision, IsOfTheCellAroundOneThatTouchesItsWall)
{
  // Two of eight bricks meet at a wall, which a nucleus within one of them touches with a few of its voxels.
  const LabelVolume bricks = Bricks({ { 2, 2, 2 } }, 12);
  const VoxelIndex  inFirst{ { 20, 18, 18 } };
  const VertexId    around = bricks.At(inFirst[0], inFirst[1], inFirst[2]);
  const VertexId    nucleus = NumberOfVertices(bricks);
  const LabelVolume volume = MakeImage(bricks.size, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    const VertexId cell = bricks.At(x, y, z);
    return cell == around && Radius(x - inFirst[0], y - inFirst[1], z - inFirst[2]) < 4.2 ? nucleus : cell;
  });
  const auto        cells = FindCellsAround(volume, FindImageWalls(volume), NumberOfVertices(volume));
  ASSERT_NE(around, ExteriorVertex);
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].cell, around);
  ExpectExact(volume);
  EXPECT_TRUE(FindCellsAround(bricks, FindImageWalls(bricks), NumberOfVertices(bricks)).empty());
}

TEST(LabelDivision, GivesAGroupOfManyWithinOne)
{
  LabelVolume volume = Bricks({ { 2, 2, 2 } }, 4);
  const auto  around = NumberOfVertices(volume);
  LabelVolume shell = MakeImage({ { 24, 24, 24 } }, [&](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
    const VertexId cell = volume.At(x - 3, y - 3, z - 3);
    return cell != ExteriorVertex ? cell : Radius(x - 12, y - 12, z - 12) < 11.5 ? around : ExteriorVertex;
  });
  ExpectExact(shell);
}

TEST(LabelDivision, GivesABarThroughAir)
{
  // A bar from one block of bricks to another.
  const LabelVolume bricks = Bricks({ { 2, 2, 2 } }, 6);
  const auto        bar = NumberOfVertices(bricks);
  const LabelVolume volume = MakeImage({ { 60, 26, 26 } }, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    const VertexId cell = x < 24 ? bricks.At(x, y, z) : bricks.At(59 - x, y, z);
    const bool     isBar = y >= 8 && y < 12 && z >= 7 && z < 11;
    return cell != ExteriorVertex && x >= 24                     ? bar + cell
           : cell == ExteriorVertex && isBar && x > 10 && x < 48 ? bar
                                                                 : cell;
  });
  ExpectExact(volume);
}

TEST(LabelDivision, GivesAirAlongEdges)
{
  // Cubes whose edges are rounded off: each two share a disk in the middle of a face.
  const LabelVolume volume = MakeImage({ { 32, 32, 32 } }, [](std::int32_t x, std::int32_t y, std::int32_t z) {
    const auto   at = [](std::int32_t i) { return (i - 4) % 8 - 3.5; };
    const auto   isIn = [](std::int32_t i) { return i >= 4 && i < 28; };
    const double r = Radius(at(x), at(y), at(z));
    return isIn(x) && isIn(y) && isIn(z) && r < 4.6
             ? VertexId{ 1 + (x - 4) / 8 + 3 * ((y - 4) / 8) + 9 * ((z - 4) / 8) }
             : ExteriorVertex;
  });
  EXPECT_EQ(ExpectExact(volume), 27u + 54u);
}
