/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/WallEdgeLengths.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

TEST(WallEdgeLengths, SegmentsAreTheRoundedLengthAndAtLeastOne)
{
  EXPECT_EQ(NumberOfSegments(0.0, 1.0), 1);
  EXPECT_EQ(NumberOfSegments(1.4, 1.0), 1);
  EXPECT_EQ(NumberOfSegments(1.6, 1.0), 2);
  EXPECT_EQ(NumberOfSegments(10.0, 0.1), 100);
}

TEST(WallEdgeLengths, AHexagonOfSixEquilateralTrianglesHasOnePointWithin)
{
  const double area = 6.0 * std::sqrt(3.0) / 4.0;
  EXPECT_EQ(NumberOfInteriorPoints(area, 1.0, 6), 1);
  // Twice the side: 24 triangles, 12 pieces of the outline.
  EXPECT_EQ(NumberOfInteriorPoints(4.0 * area, 1.0, 12), 7);
  EXPECT_EQ(NumberOfInteriorPoints(0.01 * area, 1.0, 12), 0);
}

TEST(WallEdgeLengths, MoreTrianglesHaveShorterEdges)
{
  const WallMesh mesh = RandomTissue(20);
  const double   few = ChooseEdgeLengths(mesh, 20 * 100.0)[0];
  const double   many = ChooseEdgeLengths(mesh, 20 * 400.0)[0];
  // Four times the triangles have edges of half the length.
  EXPECT_NEAR(few / many, 2.0, 0.2);
}

TEST(WallEdgeLengths, FactorsAreKept)
{
  const WallMesh      mesh = FourCells();
  std::vector<double> factors(mesh.walls.size(), 1.0);
  factors[4] = 0.5;
  const auto lengths = ChooseEdgeLengths(mesh, 2000.0, factors);
  EXPECT_NEAR(lengths[4] / lengths[0], 0.5, 1e-12);
  EXPECT_EQ(lengths[0], lengths[1]);
  EXPECT_LT(ChooseEdgeLengths(mesh, 2000.0)[0], lengths[0]) << "the others make room for the finer wall";
  EXPECT_THROW(ChooseEdgeLengths(mesh, 2000.0, { 1.0 }), std::invalid_argument);
}

TEST(WallEdgeLengths, FactorsByTheSizeOfTheSmallerCell)
{
  WallMesh mesh;
  mesh.walls = { { { { 1, 2 } } }, { { { 2, 3 } } }, { { { 3, ExteriorVertex } } }, { { { 4, ExteriorVertex } } } };
  const std::vector<double> volumes{ 0.0, 1.0, 1.0, 8.0, 1000.0 };
  // The median of 1, 1, 8, 1000, the upper of the two in the middle, is 8.
  const auto full = EdgeLengthFactorsByCell(mesh, volumes, 1.0);
  EXPECT_DOUBLE_EQ(full[0], 0.5);
  EXPECT_DOUBLE_EQ(full[1], 0.5);
  EXPECT_DOUBLE_EQ(full[2], 1.0);
  EXPECT_DOUBLE_EQ(full[3], 3.0) << "at most";
  EXPECT_DOUBLE_EQ(EdgeLengthFactorsByCell(mesh, volumes, 0.5)[0], std::sqrt(0.5));
  EXPECT_EQ(EdgeLengthFactorsByCell(mesh, volumes, 0.0), std::vector<double>(4, 1.0));
}
