/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallJoining.h"

#include "Common/Algorithms.h"
#include "Mesh/WallLines.h"
#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <numeric>

namespace tissue
{
namespace
{
/** Of each wall the number of the joined one. */
std::vector<WallId>
NumberJoinedWalls(const WallMesh & mesh)
{
  DisjointSets sets(mesh.walls.size());
  for (const WallLine & line : CollectWallLines(mesh))
  {
    if (line.walls.size() == 2 && mesh.walls[line.walls[0]].cells == mesh.walls[line.walls[1]].cells)
    {
      sets.Unite(line.walls[0], line.walls[1]);
    }
  }
  std::vector<WallId> ofSet(mesh.walls.size(), -1);
  std::vector<WallId> joined(mesh.walls.size());
  WallId              count = 0;
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    WallId & number = ofSet[sets.Find(w)];
    number = number < 0 ? count++ : number;
    joined[w] = number;
  }
  return joined;
}

void
CountCells(WallMesh & mesh)
{
  // Points within a wall stay there; they are most, and need no list.
  const std::vector<std::uint8_t>      before = std::move(mesh.numberOfCells);
  std::vector<std::array<VertexId, 2>> incidences; // point, cell
  mesh.numberOfCells.assign(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    for (const PointId p : mesh.triangles[t])
    {
      if (before[p] == CellsWithinWall)
      {
        mesh.numberOfCells[p] = CellsWithinWall;
        continue;
      }
      incidences.push_back({ { p, cells[0] } });
      incidences.push_back({ { p, cells[1] } });
    }
  }
  SortUnique(incidences);
  for (const auto & incidence : incidences)
  {
    ++mesh.numberOfCells[incidence[0]];
  }
}
} // namespace

void
JoinWalls(WallMesh & mesh)
{
  const std::vector<WallId> joined = NumberJoinedWalls(mesh);
  std::vector<std::size_t>  order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return joined[mesh.wallOfTriangle[a]] < joined[mesh.wallOfTriangle[b]];
  });
  const std::vector<Triangle>       triangles = mesh.triangles;
  const std::vector<WallId>         wallOfTriangle = mesh.wallOfTriangle;
  const std::vector<WallMesh::Wall> walls = mesh.walls;
  for (std::size_t t = 0; t < order.size(); ++t)
  {
    mesh.triangles[t] = triangles[order[t]];
    mesh.wallOfTriangle[t] = joined[wallOfTriangle[order[t]]];
  }
  for (std::size_t w = 0; w < joined.size(); ++w)
  {
    mesh.walls[joined[w]] = walls[w];
  }
  mesh.walls.resize(joined.empty() ? 0 : static_cast<std::size_t>(*std::max_element(joined.begin(), joined.end())) + 1);
  CountCells(mesh);
}
} // namespace tissue
