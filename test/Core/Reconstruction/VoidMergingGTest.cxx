/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Reconstruction/VoidMerging.h"

#include "Complex/AdjacencyComplex.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
/** The exterior, cells 1 to 4, and voids 5 and 6. */
JunctionSet
FourCellsAndTwoVoids()
{
  JunctionSet set;
  set.cells.resize(5);
  set.voids.resize(2);
  return set;
}
} // namespace

TEST(VoidMerging, TetrahedraOfTheExteriorAndAVoidAreLeftOut)
{
  const auto merged =
    MergeVoids({ { { 0, 1, 2, 5 } }, { { 1, 2, 3, 5 } }, { { 1, 2, 3, 4 } } }, FourCellsAndTwoVoids());
  ASSERT_EQ(merged.size(), 2u);
  EXPECT_EQ(merged[0], Canonical({ { 1, 2, 3, 0 } }));
  EXPECT_EQ(merged[1], Canonical({ { 1, 2, 3, 4 } }));
}

TEST(VoidMerging, WallsBetweenThemAreLeftOutWithTheirPoints)
{
  WallMesh mesh;
  mesh.points = { { { 9, 9, 9 } }, { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  mesh.numberOfCells = { 2, 3, 3, 3, 2 };
  mesh.walls = { { { { 0, 5 } } }, { { { 1, 5 } } }, { { { 1, 2 } } } };
  mesh.triangles = { { { 0, 1, 2 } }, { { 1, 2, 3 } }, { { 1, 2, 4 } } };
  mesh.wallOfTriangle = { 0, 1, 2 };
  MergeVoids(mesh, FourCellsAndTwoVoids());
  ASSERT_EQ(mesh.walls.size(), 2u);
  EXPECT_EQ(mesh.walls[0].cells[0] == ExteriorVertex ? mesh.walls[0].cells[1] : mesh.walls[0].cells[0], 1);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.wallOfTriangle, (std::vector<WallId>{ 0, 1 }));
  ASSERT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.points[0], (Point{ { 0, 0, 0 } }));
  EXPECT_EQ(mesh.numberOfCells[0], 3); // cells 1 and 2, and the exterior
  EXPECT_EQ(mesh.numberOfCells[3], 2);
}
