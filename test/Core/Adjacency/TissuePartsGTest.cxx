/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/TissueParts.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
/** Two groups of four cells that meet in a junction each, far apart, and a cell alone near the second group. */
JunctionSet
TwoGroupsAndAStrayCell()
{
  JunctionSet junctions;
  junctions.cells.resize(10);
  junctions.junctions.resize(2);
  junctions.junctions[0].cells = { { 1, 2, 3, 4 } };
  junctions.junctions[1].cells = { { 5, 6, 7, 8 } };
  return junctions;
}

std::vector<Point>
CentersOfTheGroups()
{
  return { { { 0, 0, 0 } }, { { 0, 0, 0 } },  { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } },
           { { 9, 0, 0 } }, { { 10, 0, 0 } }, { { 9, 1, 0 } }, { { 9, 0, 1 } }, { { 12, 0, 0 } } };
}
} // namespace

TEST(TissueParts, GroupsThatShareNoJunctionAreParts)
{
  const TissueParts parts = FindTissueParts(TwoGroupsAndAStrayCell(), CentersOfTheGroups());
  ASSERT_EQ(parts.parts.size(), 2u);
  EXPECT_EQ(parts.parts[0], (std::vector<VertexId>{ 1, 2, 3, 4 }));
  EXPECT_EQ(parts.parts[1], (std::vector<VertexId>{ 5, 6, 7, 8, 9 }));
  EXPECT_EQ(parts.strayCells, (std::vector<VertexId>{ 9 }));
}

TEST(TissueParts, GroupInAPlaneIsStray)
{
  std::vector<Point> centers = CentersOfTheGroups();
  centers[8] = { { 10, 1, 0 } };
  const TissueParts parts = FindTissueParts(TwoGroupsAndAStrayCell(), centers);
  ASSERT_EQ(parts.parts.size(), 1u);
  EXPECT_EQ(parts.parts[0].size(), 9u);
  EXPECT_EQ(parts.strayCells, (std::vector<VertexId>{ 5, 6, 7, 8, 9 }));
}

TEST(TissueParts, JoinedTheyAreOne)
{
  const TissueParts parts = JoinTissueParts(TwoGroupsAndAStrayCell());
  ASSERT_EQ(parts.parts.size(), 1u);
  EXPECT_EQ(parts.parts[0].size(), 9u);
  EXPECT_TRUE(parts.strayCells.empty());
}
