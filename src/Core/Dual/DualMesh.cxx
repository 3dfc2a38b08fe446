/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/DualMesh.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace tissue
{
DualMesh
Dualize(const AdjacencyComplex & complex, std::vector<Point> corners)
{
  if (corners.size() != complex.NumberOfTetrahedra())
  {
    throw std::invalid_argument("Dualize: " + std::to_string(corners.size()) + " corners for " +
                                std::to_string(complex.NumberOfTetrahedra()) + " tetrahedra");
  }
  const std::vector<std::int32_t> cornerOf = complex.GetTetrahedronRanks();
  DualMesh                        dual;
  dual.corners = std::move(corners);
  for (const AdjacencyComplex::Edge & edge : complex.GetEdges())
  {
    DualMesh::Wall wall;
    wall.cells = edge.vertices;
    if (wall.cells[0] == ExteriorVertex)
    {
      std::swap(wall.cells[0], wall.cells[1]);
    }
    // The ring of (u, v) is counterclockwise seen from v.
    for (const TetrahedronId id : complex.GetRing(wall.cells[0], wall.cells[1]).tetrahedra)
    {
      wall.corners.push_back(cornerOf[id]);
    }
    // The smallest corner comes first, so that equal complexes give equal walls whatever their history.
    std::rotate(wall.corners.begin(), std::min_element(wall.corners.begin(), wall.corners.end()), wall.corners.end());
    dual.walls.push_back(std::move(wall));
  }
  return dual;
}

WallMesh
TriangulateAsStars(const DualMesh & dual)
{
  WallMesh mesh;
  mesh.points = dual.corners;
  mesh.numberOfCells.assign(dual.corners.size(), CellsAtCorner);
  for (const DualMesh::Wall & wall : dual.walls)
  {
    const auto        wallId = static_cast<WallId>(mesh.walls.size());
    const auto        center = static_cast<PointId>(mesh.points.size());
    const std::size_t n = wall.corners.size();
    Point             sum{ { 0.0, 0.0, 0.0 } };
    for (std::size_t i = 0; i < n; ++i)
    {
      sum = sum + dual.corners[wall.corners[i]];
      mesh.triangles.push_back({ { center, wall.corners[i], wall.corners[(i + 1) % n] } });
      mesh.wallOfTriangle.push_back(wallId);
    }
    mesh.points.push_back((1.0 / static_cast<double>(n)) * sum);
    mesh.numberOfCells.push_back(CellsWithinWall);
    mesh.walls.push_back({ wall.cells });
  }
  return mesh;
}
} // namespace tissue
