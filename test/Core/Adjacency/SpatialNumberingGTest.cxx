/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/SpatialNumbering.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

using namespace testing_complexes;

namespace
{
/** A tissue with labels, of which the last two cells are voids. */
JunctionSet
TissueWithVoids(const std::vector<Point> & centers)
{
  JunctionSet junctions = JunctionsOf(DelaunayComplex(centers), centers);
  for (std::size_t v = 0; v < junctions.cells.size(); ++v)
  {
    junctions.cells[v].label = static_cast<Label>(10 * v);
  }
  junctions.voids.assign(junctions.cells.end() - 2, junctions.cells.end());
  junctions.cells.resize(junctions.cells.size() - 2);
  junctions.votes = { { junctions.junctions.front().cells, 0.25 }, { junctions.junctions.back().cells, 0.75 } };
  return junctions;
}
} // namespace

TEST(SpatialNumbering, TheExteriorIsFirstAndTheVoidsAreLast)
{
  const auto             centers = RandomCenters(30, 1);
  const JunctionSet      junctions = TissueWithVoids(centers);
  const SpatialNumbering numbering = NumberSpatially(junctions, centers);
  ASSERT_EQ(numbering.order.size(), 31u);
  EXPECT_EQ(numbering.order[ExteriorVertex], ExteriorVertex);
  for (VertexId i = 0; i < 31; ++i)
  {
    EXPECT_EQ(numbering.ranks[numbering.order[i]], i);
    EXPECT_EQ(junctions.IsVoid(numbering.order[i]), junctions.IsVoid(i));
  }
}

TEST(SpatialNumbering, RenumberedJunctionsHaveTheSameOfTheSameCells)
{
  const auto             centers = RandomCenters(30, 1);
  const JunctionSet      junctions = TissueWithVoids(centers);
  const SpatialNumbering numbering = NumberSpatially(junctions, centers);
  const JunctionSet      renumbered = Renumbered(junctions, numbering);
  const auto             renumber = [&numbering](auto cells) {
    for (VertexId & v : cells)
    {
      v = numbering.ranks[v];
    }
    return cells;
  };
  for (VertexId v = 0; v < junctions.NumberOfVertices(); ++v)
  {
    EXPECT_EQ(renumbered.CellOfVertex(numbering.ranks[v]).label, junctions.CellOfVertex(v).label);
    EXPECT_EQ(renumbered.CellOfVertex(numbering.ranks[v]).center, junctions.CellOfVertex(v).center);
  }
  ASSERT_EQ(renumbered.walls.size(), junctions.walls.size());
  for (const Wall & wall : junctions.walls)
  {
    const Wall * const found = FindWall(renumbered, renumber(wall.cells));
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->center, wall.center);
  }
  ASSERT_EQ(renumbered.junctions.size(), junctions.junctions.size());
  for (const Junction & junction : junctions.junctions)
  {
    const Junction * const found = FindJunction(renumbered, renumber(junction.cells));
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->position, junction.position);
  }
  ASSERT_EQ(renumbered.votes.size(), 2u);
  EXPECT_LT(renumbered.votes[0].cells, renumbered.votes[1].cells);
  EXPECT_EQ(renumbered.votes[0].share + renumbered.votes[1].share, 1.0);
}
