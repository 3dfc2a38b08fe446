/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <gtest/gtest.h>

using namespace tissue;

TEST(JunctionSet, FindsWallsAndJunctionsByTheirCellsInAnyOrder)
{
  JunctionSet set;
  set.walls.resize(3);
  set.walls[0].cells = { { 0, 3 } };
  set.walls[1].cells = { { 1, 2 } };
  set.walls[2].cells = { { 1, 3 } };
  set.junctions.resize(2);
  set.junctions[0].cells = { { 0, 1, 2, 3 } };
  set.junctions[1].cells = { { 1, 2, 3, 4 } };
  EXPECT_EQ(FindWall(set, { { 2, 1 } }), &set.walls[1]);
  EXPECT_EQ(FindWall(set, { { 0, 3 } }), &set.walls[0]);
  EXPECT_EQ(FindWall(set, { { 2, 3 } }), nullptr);
  EXPECT_EQ(FindJunction(set, { { 4, 2, 1, 3 } }), &set.junctions[1]);
  EXPECT_EQ(FindJunction(set, { { 0, 1, 2, 4 } }), nullptr);
  EXPECT_EQ(FindJunction(JunctionSet(), { { 0, 1, 2, 3 } }), nullptr);
}
