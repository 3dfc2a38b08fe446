/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Reconstruction/VertexRestoration.h"
#include "TestWallMeshes.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace testing_wall_meshes;

namespace
{
constexpr int NumberOfCells = 20;

/** The vertex of each number: from the last one to the first, but for the exterior. */
std::vector<VertexId>
BackwardOrder()
{
  std::vector<VertexId> order(NumberOfCells + 1);
  std::iota(order.rbegin(), order.rend(), VertexId{ 1 });
  order[ExteriorVertex] = ExteriorVertex;
  return order;
}

std::vector<Point>
InOrder(const std::vector<Point> & centers, const std::vector<VertexId> & order)
{
  std::vector<Point> ordered;
  for (const VertexId v : order)
  {
    ordered.push_back(centers[v]);
  }
  return ordered;
}
} // namespace

TEST(VertexRestoration, TetrahedraAreThoseOfTheVertices)
{
  const auto             centers = RandomCenters(NumberOfCells, 1);
  const auto             order = BackwardOrder();
  const AdjacencyComplex numbered = DelaunayComplex(InOrder(centers, order));
  EXPECT_EQ(RestoreVertices(numbered.GetTetrahedra(), order), DelaunayComplex(centers).GetTetrahedra());
}

TEST(VertexRestoration, WallsAreThoseOfTheVerticesTurnedAndTheirCornersInOrder)
{
  const auto             centers = RandomCenters(NumberOfCells, 1);
  const auto             order = BackwardOrder();
  const AdjacencyComplex numbered = DelaunayComplex(InOrder(centers, order));
  WallMesh               mesh = StarsOf(numbered, InOrder(centers, order));
  RestoreVertices(mesh, numbered.GetTetrahedra(), order);
  ExpectSound(mesh, NumberOfCells);

  const WallMesh expected = RandomTissue(NumberOfCells);
  ASSERT_EQ(mesh.points.size(), expected.points.size());
  for (std::size_t corner = 0; corner < numbered.NumberOfTetrahedra(); ++corner)
  {
    EXPECT_LT(Distance(mesh.points[corner], expected.points[corner]), 1e-6);
  }
  std::vector<VertexPair> cells = CellsOfWalls(mesh);
  EXPECT_NE(cells, CellsOfWalls(expected)) << "walls stay in the order of the numbers";
  std::sort(cells.begin(), cells.end());
  std::vector<VertexPair> expectedCells = CellsOfWalls(expected);
  std::sort(expectedCells.begin(), expectedCells.end());
  EXPECT_EQ(cells, expectedCells);

  const auto check = CheckCellSurfaces(mesh, NumberOfCells + 1);
  const auto expectedCheck = CheckCellSurfaces(expected, NumberOfCells + 1);
  for (int v = 1; v <= NumberOfCells; ++v)
  {
    EXPECT_NEAR(check.cells[v].volume, expectedCheck.cells[v].volume, 1e-6);
  }
}
