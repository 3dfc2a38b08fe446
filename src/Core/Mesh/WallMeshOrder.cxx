/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallMeshOrder.h"

namespace tissue
{
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
