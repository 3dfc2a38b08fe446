/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallMeshOrder.h"

#include "Mesh/WallPieces.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace tissue
{
namespace
{
std::vector<WallId>
SortWalls(const WallMesh & mesh, const std::vector<VertexId> & ranks)
{
  for (const WallMesh::Wall & wall : mesh.walls)
  {
    const VertexId last = std::max(wall.cells[0], wall.cells[1]);
    if (static_cast<std::size_t>(last) >= ranks.size())
    {
      throw std::invalid_argument("OrderWalls: a wall of cell " + std::to_string(last) + ", but only " +
                                  std::to_string(ranks.size()) + " ranks");
    }
  }
  std::vector<WallId> order(mesh.walls.size());
  std::iota(order.begin(), order.end(), WallId{ 0 });
  const auto key = [&](WallId wall) {
    const VertexPair & cells = mesh.walls[wall].cells;
    return VertexPair{ { ranks[cells[0]], ranks[cells[1]] } };
  };
  std::stable_sort(order.begin(), order.end(), [&key](WallId a, WallId b) { return key(a) < key(b); });
  return order;
}
} // namespace

WallMesh
OrderWalls(const WallMesh & mesh, const std::vector<VertexId> & ranks)
{
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(mesh);
  WallMesh                       ordered;
  ordered.points = mesh.points;
  ordered.numberOfCells = mesh.numberOfCells;
  for (const WallId wall : SortWalls(mesh, ranks))
  {
    ordered.triangles.insert(ordered.triangles.end(),
                             mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first[wall]),
                             mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first[wall + 1]));
    ordered.wallOfTriangle.resize(ordered.triangles.size(), static_cast<WallId>(ordered.walls.size()));
    ordered.walls.push_back(mesh.walls[wall]);
  }
  return ordered;
}

std::vector<PointId>
PointsByTriangles(const WallMesh & mesh)
{
  std::vector<PointId>       order;
  std::vector<unsigned char> isDone(mesh.points.size(), 0);
  for (const bool isWithin : { false, true })
  {
    for (const auto & triangle : mesh.triangles)
    {
      for (const PointId p : triangle)
      {
        if (isDone[p] == 0 && (mesh.numberOfCells[p] == CellsWithinWall) == isWithin)
        {
          isDone[p] = 1;
          order.push_back(p);
        }
      }
    }
  }
  return order;
}

void
TakePoints(WallMesh & mesh, const std::vector<PointId> & order)
{
  std::vector<PointId>      numberOf(mesh.points.size(), -1);
  std::vector<Point>        points;
  std::vector<std::uint8_t> numberOfCells;
  points.reserve(order.size());
  numberOfCells.reserve(order.size());
  for (const PointId p : order)
  {
    numberOf[p] = static_cast<PointId>(points.size());
    points.push_back(mesh.points[p]);
    numberOfCells.push_back(mesh.numberOfCells[p]);
  }
  mesh.points = std::move(points);
  mesh.numberOfCells = std::move(numberOfCells);
  for (auto & triangle : mesh.triangles)
  {
    for (PointId & p : triangle)
    {
      p = numberOf[p];
    }
  }
}

void
PutLinePointsFirst(WallMesh & mesh)
{
  std::vector<unsigned char> isUsed(mesh.points.size(), 0);
  for (const auto & triangle : mesh.triangles)
  {
    for (const PointId p : triangle)
    {
      isUsed[p] = 1;
    }
  }
  std::vector<PointId> order;
  for (const bool isWithin : { false, true })
  {
    for (std::size_t p = 0; p < isUsed.size(); ++p)
    {
      if (isUsed[p] != 0 && (mesh.numberOfCells[p] == CellsWithinWall) == isWithin)
      {
        order.push_back(static_cast<PointId>(p));
      }
    }
  }
  TakePoints(mesh, order);
}
} // namespace tissue
