/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Reconstruction/VoidMerging.h"

#include "Complex/AdjacencyComplex.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>

namespace tissue
{
std::vector<VertexQuadruple>
MergeVoids(const std::vector<VertexQuadruple> & tetrahedra, const JunctionSet & junctions)
{
  std::vector<VertexQuadruple> merged;
  for (VertexQuadruple t : tetrahedra)
  {
    std::replace_if(
      t.begin(), t.end(), [&junctions](VertexId v) { return junctions.IsVoid(v); }, ExteriorVertex);
    if (std::count(t.begin(), t.end(), ExteriorVertex) <= 1)
    {
      merged.push_back(Canonical(t));
    }
  }
  std::sort(merged.begin(), merged.end());
  return merged;
}

void
MergeVoids(WallMesh & mesh, const JunctionSet & junctions)
{
  if (junctions.voids.empty())
  {
    return;
  }
  WallMesh                                                 merged;
  std::vector<WallId>                                      newWall(mesh.walls.size(), -1);
  std::vector<boost::container::small_vector<VertexId, 4>> cellsOfPoint(mesh.points.size());
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    VertexPair cells = mesh.walls[w].cells;
    std::replace_if(
      cells.begin(), cells.end(), [&junctions](VertexId v) { return junctions.IsVoid(v); }, ExteriorVertex);
    if (cells[0] != ExteriorVertex)
    {
      newWall[w] = static_cast<WallId>(merged.walls.size());
      merged.walls.push_back({ cells });
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const WallId wall = newWall[mesh.wallOfTriangle[t]];
    if (wall < 0)
    {
      continue;
    }
    merged.triangles.push_back(mesh.triangles[t]);
    merged.wallOfTriangle.push_back(wall);
    for (const PointId p : mesh.triangles[t])
    {
      auto & cells = cellsOfPoint[p];
      for (const VertexId v : merged.walls[wall].cells)
      {
        if (std::find(cells.begin(), cells.end(), v) == cells.end())
        {
          cells.push_back(v);
        }
      }
    }
  }
  std::vector<PointId> newPoint(mesh.points.size(), 0);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (!cellsOfPoint[p].empty())
    {
      newPoint[p] = static_cast<PointId>(merged.points.size());
      merged.points.push_back(mesh.points[p]);
      merged.numberOfCells.push_back(static_cast<std::uint8_t>(cellsOfPoint[p].size()));
    }
  }
  for (auto & triangle : merged.triangles)
  {
    std::transform(triangle.begin(), triangle.end(), triangle.begin(), [&newPoint](PointId p) { return newPoint[p]; });
  }
  mesh = std::move(merged);
}
} // namespace tissue
