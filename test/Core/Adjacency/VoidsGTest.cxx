/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/AdjacencyComplex.h"
#include "TissueTessellationCore/Adjacency/Voids.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
/** Cells 1 to 4 around the voids 5 and 6: cells 1, 2, 3 meet the exterior and both voids, 1 and 2 share a wall. */
JunctionSet
FourCellsTwoVoids()
{
  JunctionSet set;
  set.cells.resize(5);
  set.cells[ExteriorVertex].numberOfVoxels = 100;
  set.cells[ExteriorVertex].volume = 50.0;
  set.voids.resize(2);
  set.voids[0].numberOfVoxels = 8;
  set.voids[0].volume = 4.0;
  set.voids[1].numberOfVoxels = 2;
  set.voids[1].volume = 1.0;
  const auto wall = [&set](VertexPair cells, std::int64_t faces, double area, double x) {
    set.walls.push_back({ cells, faces, area, { { x, 0.0, 0.0 } } });
  };
  wall({ { 0, 1 } }, 6, 3.0, 0.0);
  wall({ { 1, 2 } }, 4, 2.0, 7.0);
  wall({ { 1, 5 } }, 2, 1.0, 4.0);
  const auto junction = [&set](VertexQuadruple cells, std::int64_t blocks, double x) {
    Junction item;
    item.cells = cells;
    item.numberOfBlocks = blocks;
    item.position = { { x, 0.0, 0.0 } };
    set.junctions.push_back(item);
  };
  junction({ { 0, 1, 2, 3 } }, 2, 10.0);
  junction({ { 0, 1, 2, 5 } }, 1, 99.0);
  junction({ { 1, 2, 3, 5 } }, 3, 20.0);
  junction({ { 1, 2, 3, 6 } }, 4, 30.0);
  set.votes = { { { { 0, 1, 2, 3 } }, 0.5 }, { { { 0, 1, 2, 5 } }, 1.0 }, { { { 1, 2, 3, 5 } }, 0.75 } };
  return set;
}
} // namespace

TEST(Voids, MergedJunctionsAreTheExteriors)
{
  const JunctionSet merged = MergeVoids(FourCellsTwoVoids());
  EXPECT_TRUE(merged.voids.empty());
  EXPECT_EQ(merged.cells[ExteriorVertex].numberOfVoxels, 110);
  EXPECT_EQ(merged.cells[ExteriorVertex].numberOfStrayVoxels, 10);
  EXPECT_EQ(merged.cells[ExteriorVertex].numberOfPieces, 3);
  EXPECT_DOUBLE_EQ(merged.cells[ExteriorVertex].volume, 55.0);

  ASSERT_EQ(merged.walls.size(), 2u);
  EXPECT_EQ(merged.walls[0].cells, (VertexPair{ { 0, 1 } }));
  EXPECT_EQ(merged.walls[0].numberOfFaces, 8);
  EXPECT_DOUBLE_EQ(merged.walls[0].area, 4.0);
  EXPECT_DOUBLE_EQ(merged.walls[0].center[0], 1.0);
  EXPECT_EQ(merged.walls[1].cells, (VertexPair{ { 1, 2 } }));

  // The junction of the exterior and a void is none any more; three are one, where most of its blocks are.
  ASSERT_EQ(merged.junctions.size(), 1u);
  EXPECT_EQ(merged.junctions[0].cells, (VertexQuadruple{ { 0, 1, 2, 3 } }));
  EXPECT_EQ(merged.junctions[0].numberOfBlocks, 9);
  EXPECT_EQ(merged.junctions[0].numberOfClusters, 3);
  EXPECT_DOUBLE_EQ(merged.junctions[0].position[0], 30.0);
  ASSERT_EQ(merged.votes.size(), 1u);
  EXPECT_EQ(merged.votes[0].cells, (VertexQuadruple{ { 0, 1, 2, 3 } }));
  EXPECT_EQ(merged.votes[0].share, 0.75);
}

TEST(Voids, OfOtherPartsAreTheExteriorOfThePartWithin)
{
  // Void 5 is of the part of cells 1 to 3, in which cell 4 lies, a part of its own.
  JunctionSet set = FourCellsTwoVoids();
  set.walls.push_back({ { { 4, 5 } }, 1, 1.0, { { 0.0, 0.0, 0.0 } } });
  const JunctionSet merged = MergeVoidsOfOtherParts(set, { -1, 0, 0, 0, 1, 0, 0 });
  ASSERT_EQ(merged.walls.size(), 4u);
  EXPECT_EQ(merged.walls[1].cells, (VertexPair{ { 0, 4 } }));
  EXPECT_EQ(merged.walls[3].cells, (VertexPair{ { 1, 5 } }));
  EXPECT_EQ(merged.voids.size(), 2u);
}
