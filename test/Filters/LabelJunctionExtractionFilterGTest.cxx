/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace tissue_test;

template <typename TPixel>
class LabelJunctionExtraction : public ::testing::Test
{};
using PixelTypes =
  ::testing::Types<unsigned char, signed char, unsigned short, short, unsigned int, int, unsigned long long, long long>;
TYPED_TEST_SUITE(LabelJunctionExtraction, PixelTypes);

void
ExpectPoint(const tissue::Point & point, double x, double y, double z)
{
  EXPECT_NEAR(point[0], x, 1e-9);
  EXPECT_NEAR(point[1], y, 1e-9);
  EXPECT_NEAR(point[2], z, 1e-9);
}
} // namespace

// All values derived by hand.
TYPED_TEST(LabelJunctionExtraction, FourCubesAroundALine)
{
  const tissue::JunctionSet set = Extract(MakeFourCubes<TypeParam>().GetPointer());

  ASSERT_EQ(set.cells.size(), 5u);
  EXPECT_EQ(set.cells[0].label, 0);
  EXPECT_EQ(set.cells[0].numberOfVoxels, 12 * 12 * 8 - 4 * 64);
  EXPECT_EQ(set.cells[0].numberOfStrayVoxels, 0);
  EXPECT_EQ(set.cells[0].numberOfPieces, 1);
  for (int i = 1; i <= 4; ++i)
  {
    EXPECT_EQ(set.cells[i].label, 10 * i);
    EXPECT_EQ(set.cells[i].numberOfVoxels, 64);
    EXPECT_DOUBLE_EQ(set.cells[i].volume, 64.0);
    EXPECT_EQ(set.cells[i].numberOfStrayVoxels, 0);
    EXPECT_EQ(set.cells[i].numberOfPieces, 1);
    EXPECT_TRUE(set.cells[i].touchesExterior);
    EXPECT_FALSE(set.cells[i].touchesBorder);
    ExpectPoint(set.cells[i].center, i % 2 == 1 ? 3.5 : 7.5, i <= 2 ? 3.5 : 7.5, 3.5);
  }

  // Each cell to the exterior and to its two neighbours; 10-40 and 20-30 share an edge only.
  ASSERT_EQ(set.walls.size(), 8u);
  EXPECT_EQ(set.walls[0].cells, (tissue::VertexPair{ { 0, 1 } }));
  EXPECT_EQ(set.walls[0].numberOfFaces, 4 * 16);
  EXPECT_EQ(set.walls[4].cells, (tissue::VertexPair{ { 1, 2 } }));
  EXPECT_EQ(set.walls[4].numberOfFaces, 16);
  EXPECT_DOUBLE_EQ(set.walls[4].area, 16.0);
  ExpectPoint(set.walls[4].center, 5.5, 3.5, 3.5);
  EXPECT_EQ(set.walls[5].cells, (tissue::VertexPair{ { 1, 3 } }));
  ExpectPoint(set.walls[5].center, 3.5, 5.5, 3.5);

  // The line x = y = 5.5 holds all four cells in its three inner blocks, and the exterior as well in the two at its
  // ends, which are crowded: all five subsets of four, all ten of three.
  EXPECT_EQ(set.numberOfCrowdedBlocks, 2);
  ASSERT_EQ(set.junctions.size(), 5u);
  EXPECT_EQ(set.tripleLines.size(), 10u);
  const tissue::Junction & exteriorJunction = set.junctions[0];
  EXPECT_EQ(exteriorJunction.cells, (tissue::VertexQuadruple{ { 0, 1, 2, 3 } }));
  EXPECT_EQ(exteriorJunction.numberOfBlocks, 2);
  EXPECT_EQ(exteriorJunction.numberOfExactBlocks, 0);
  // Two clusters of one block each: the first in raster order counts.
  EXPECT_EQ(exteriorJunction.numberOfClusters, 2);
  ExpectPoint(exteriorJunction.position, 5.5, 5.5, 1.5);
  const tissue::Junction & line = set.junctions[4];
  EXPECT_EQ(line.cells, (tissue::VertexQuadruple{ { 1, 2, 3, 4 } }));
  EXPECT_EQ(line.numberOfBlocks, 5);
  EXPECT_EQ(line.numberOfExactBlocks, 3);
  EXPECT_EQ(line.numberOfClusters, 1);
  ExpectPoint(line.position, 5.5, 5.5, 3.5);
}

// All values derived by hand.
TEST(LabelJunctionExtraction, TripleLinesCountTheirBlocks)
{
  const tissue::JunctionSet set = Extract(MakeFourCubes<short>().GetPointer());
  // The wall 10-20 ends at the exterior along three sides: 3 blocks along y at z = 1.5 and at z = 5.5, 5 blocks along z
  // at y = 1.5, corners counted there; on the fourth side the two crowded blocks.
  ASSERT_EQ(set.tripleLines[0].cells, (tissue::VertexTriple{ { 0, 1, 2 } }));
  EXPECT_EQ(set.tripleLines[0].numberOfBlocks, 3 + 3 + 5 + 2);
  // The whole line x = y = 5.5.
  ASSERT_EQ(set.tripleLines[9].cells, (tissue::VertexTriple{ { 2, 3, 4 } }));
  EXPECT_EQ(set.tripleLines[9].numberOfBlocks, 5);
}

TEST(LabelJunctionExtraction, AnotherExteriorLabelGivesTheSame)
{
  const tissue::JunctionSet zero = Extract(MakeFourCubes<short>(0).GetPointer());
  for (const int exterior : { 1, 99, -5 })
  {
    const tissue::JunctionSet set = Extract(MakeFourCubes<short>(exterior).GetPointer());
    EXPECT_EQ(set.cells[0].label, exterior);
    ASSERT_EQ(set.junctions.size(), zero.junctions.size());
    for (std::size_t i = 0; i < zero.junctions.size(); ++i)
    {
      EXPECT_EQ(set.junctions[i].cells, zero.junctions[i].cells);
      EXPECT_EQ(set.junctions[i].position, zero.junctions[i].position);
    }
  }
}

// Rotation by 90 degrees about z, then a shift; the index (i, j, k) of the region is at
// (100 - 0.5 * j, 200 + 2 * i, 300 + 3 * k).
TEST(LabelJunctionExtraction, SpacingOriginDirectionAndStartIndexAreApplied)
{
  const itk::Index<3> start = { { -7, 4, 11 } };
  const auto          plain = Extract(MakeFourCubes<short>().GetPointer());
  const auto          image = MakeFourCubes<short>(0, start);
  const double        spacing[3] = { 2.0, 0.5, 3.0 };
  image->SetSpacing(spacing);
  itk::Matrix<double, 3, 3> direction;
  direction(0, 1) = -1.0;
  direction(1, 0) = 1.0;
  direction(2, 2) = 1.0;
  image->SetDirection(direction);
  const double origin[3] = { 100.0, 200.0, 300.0 };
  image->SetOrigin(origin);
  const auto turned = Extract(image.GetPointer());

  const auto expectTransformed = [&](const tissue::Point & index, const tissue::Point & point) {
    ExpectPoint(point,
                100.0 - 0.5 * (index[1] + start[1]),
                200.0 + 2.0 * (index[0] + start[0]),
                300.0 + 3.0 * (index[2] + start[2]));
  };
  ASSERT_EQ(turned.cells.size(), plain.cells.size());
  for (std::size_t i = 1; i < plain.cells.size(); ++i)
  {
    expectTransformed(plain.cells[i].center, turned.cells[i].center);
    EXPECT_DOUBLE_EQ(turned.cells[i].volume, 3.0 * plain.cells[i].volume);
  }
  ASSERT_EQ(turned.junctions.size(), plain.junctions.size());
  for (std::size_t i = 0; i < plain.junctions.size(); ++i)
  {
    EXPECT_EQ(turned.junctions[i].cells, plain.junctions[i].cells);
    expectTransformed(plain.junctions[i].position, turned.junctions[i].position);
  }
  const auto size = image->GetLargestPossibleRegion().GetSize();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(turned.grid.size[axis], static_cast<std::int32_t>(size[axis]));
  }
  expectTransformed({ { 0.0, 0.0, 0.0 } }, turned.grid.origin);
  ExpectPoint(turned.grid.steps[0], 0.0, 2.0, 0.0);
  ExpectPoint(turned.grid.steps[1], -0.5, 0.0, 0.0);
  ExpectPoint(turned.grid.steps[2], 0.0, 0.0, 3.0);
  // The wall 10-20 is normal to the image's x, whose faces are 0.5 * 3; the wall 10-30 to y: 2 * 3.
  ASSERT_EQ(turned.walls.size(), plain.walls.size());
  EXPECT_DOUBLE_EQ(turned.walls[4].area, 16 * 1.5);
  EXPECT_DOUBLE_EQ(turned.walls[5].area, 16 * 6.0);
  expectTransformed(plain.walls[4].center, turned.walls[4].center);
  // To the exterior: a cell shows one side along x, one along y and both along z, which are 2 * 0.5.
  EXPECT_DOUBLE_EQ(turned.walls[0].area, 16 * 1.5 + 16 * 6.0 + 32 * 1.0);
  const double areas[3] = { 24.0, 96.0, 32.0 };
  expectTransformed({ { (1.5 * areas[0] + 3.5 * areas[1] + 3.5 * areas[2]) / 152.0,
                        (3.5 * areas[0] + 1.5 * areas[1] + 3.5 * areas[2]) / 152.0,
                        3.5 } },
                    turned.walls[0].center);
}

TEST(LabelJunctionExtraction, LabelsMayBeLargeOrNegative)
{
  constexpr long long       labels[4] = { std::numeric_limits<long long>::min(), -1, 1LL << 40, (1LL << 62) + 1024 };
  const auto                image = MakeImage<long long>({ { 4, 4, 1 } }, [&](long x, long y, long) {
    const bool isInside = x >= 1 && x < 3 && y >= 1 && y < 3;
    return isInside ? labels[(x - 1) + 2 * (y - 1)] : 0;
  });
  const tissue::JunctionSet set = Extract(image.GetPointer());
  ASSERT_EQ(set.cells.size(), 5u);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(set.cells[i + 1].label, labels[i]);
    EXPECT_TRUE(set.cells[i + 1].touchesBorder);
  }
}
