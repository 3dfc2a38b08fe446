/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallMeshOrder.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

using namespace tissue_test;

namespace
{
using Corners = std::array<Point, 3>;

/** The triangles of each wall by their places. */
std::map<VertexPair, std::vector<Corners>>
TrianglesByCells(const WallMesh & mesh)
{
  std::map<VertexPair, std::vector<Corners>> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & triangle = mesh.triangles[t];
    triangles[mesh.walls[mesh.wallOfTriangle[t]].cells].push_back(
      { { mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]] } });
  }
  return triangles;
}

/** Of one cell after another backwards, the exterior first. */
std::vector<VertexId>
BackwardRanks(VertexId numberOfCells)
{
  std::vector<VertexId> ranks(numberOfCells + 1);
  std::iota(ranks.rbegin(), ranks.rend(), VertexId{ 1 });
  ranks[ExteriorVertex] = 0;
  return ranks;
}
} // namespace

TEST(WallMeshOrder, WallsAreOrderedByTheRanksOfTheirCells)
{
  const std::vector<VertexId> ranks = BackwardRanks(20);
  const WallMesh              mesh = OrderWalls(RandomTissue(20), ranks);
  for (std::size_t w = 1; w < mesh.walls.size(); ++w)
  {
    const VertexPair & before = mesh.walls[w - 1].cells;
    const VertexPair & cells = mesh.walls[w].cells;
    EXPECT_LT((VertexPair{ { ranks[before[0]], ranks[before[1]] } }),
              (VertexPair{ { ranks[cells[0]], ranks[cells[1]] } }));
  }
}

TEST(WallMeshOrder, TheTrianglesOfAWallStayInTheirOrderAndPlace)
{
  const WallMesh before = RandomTissue(20);
  const WallMesh mesh = OrderWalls(before, BackwardRanks(20));
  ExpectSound(mesh, 20);
  EXPECT_EQ(TrianglesByCells(mesh), TrianglesByCells(before));
}

TEST(WallMeshOrder, PointsAreNumberedByTheFirstTriangleThatHasThem)
{
  WallMesh mesh = OrderWalls(RandomTissue(20), BackwardRanks(20));
  TakePoints(mesh, PointsByTriangles(mesh));
  ExpectSound(mesh, 20);
  const auto numberOnLines = static_cast<PointId>(std::count_if(
    mesh.numberOfCells.begin(), mesh.numberOfCells.end(), [](int cells) { return cells > CellsWithinWall; }));
  PointId    nextOnLines = 0;
  PointId    nextWithin = numberOnLines;
  for (const auto & triangle : mesh.triangles)
  {
    for (const PointId p : triangle)
    {
      PointId & next = mesh.numberOfCells[p] == CellsWithinWall ? nextWithin : nextOnLines;
      EXPECT_LE(p, next);
      next = std::max(next, p + 1);
    }
  }
  EXPECT_EQ(nextOnLines, numberOnLines);
  EXPECT_EQ(nextWithin, static_cast<PointId>(mesh.points.size()));
}

TEST(WallMeshOrder, RefusesRanksThatAreTooFew)
{
  EXPECT_THROW(OrderWalls(RandomTissue(20), BackwardRanks(19)), std::invalid_argument);
}
