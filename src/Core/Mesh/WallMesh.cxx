/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace tissue
{
namespace
{
[[noreturn]] void
Refuse(const std::string & what, std::int64_t value, const std::string & limit)
{
  throw std::invalid_argument("Wall mesh: " + what + " is " + std::to_string(value) + ", must be " + limit);
}

void
RequireIndex(std::int64_t index, std::int64_t end, const char * what, const char * owner, std::size_t ownerIndex)
{
  if (index < 0 || index >= end)
  {
    Refuse(std::string(what) + " of " + owner + " " + std::to_string(ownerIndex),
           index,
           "at least 0 and below " + std::to_string(end));
  }
}
} // namespace

std::vector<VertexPair>
CellsOfWalls(const WallMesh & mesh)
{
  std::vector<VertexPair> pairs;
  pairs.reserve(mesh.walls.size());
  for (const WallMesh::Wall & wall : mesh.walls)
  {
    pairs.push_back(wall.cells);
  }
  return pairs;
}

void
RequireConsistentIndices(const WallMesh & mesh, VertexId numberOfVertices)
{
  // The lengths of the lists come first, as the indices are then read by them.
  const std::int64_t numberOfTriangles = mesh.triangles.size();
  const std::int64_t numberOfPoints = mesh.points.size();
  const std::int64_t numberOfWalls = mesh.walls.size();
  if (numberOfVertices < 1)
  {
    Refuse("the number of vertices", numberOfVertices, "at least 1, the exterior");
  }
  // Half-edges, three to a triangle, are numbered with 32 bits.
  constexpr std::int64_t maximalNumberOfTriangles = std::numeric_limits<std::uint32_t>::max() / 3;
  if (numberOfTriangles > maximalNumberOfTriangles)
  {
    Refuse("the number of triangles", numberOfTriangles, "at most " + std::to_string(maximalNumberOfTriangles));
  }
  if (mesh.wallOfTriangle.size() != mesh.triangles.size())
  {
    Refuse("the length of wallOfTriangle",
           mesh.wallOfTriangle.size(),
           "the number of triangles, " + std::to_string(numberOfTriangles));
  }
  if (!mesh.numberOfCells.empty() && mesh.numberOfCells.size() != mesh.points.size())
  {
    Refuse("the length of numberOfCells",
           mesh.numberOfCells.size(),
           "0 or the number of points, " + std::to_string(numberOfPoints));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    RequireIndex(mesh.wallOfTriangle[t], numberOfWalls, "the wall", "triangle", t);
    for (const PointId point : mesh.triangles[t])
    {
      RequireIndex(point, numberOfPoints, "a point", "triangle", t);
    }
  }
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    const VertexPair & cells = mesh.walls[w].cells;
    RequireIndex(cells[0], numberOfVertices, "the first cell", "wall", w);
    RequireIndex(cells[1], numberOfVertices, "the second cell", "wall", w);
    if (cells[0] == cells[1])
    {
      Refuse("the second cell of wall " + std::to_string(w), cells[1], "another than the first");
    }
  }
}
} // namespace tissue
