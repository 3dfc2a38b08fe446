/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Reconstruction/VertexRestoration.h"

#include "Complex/AdjacencyComplex.h"
#include "Mesh/WallMeshOrder.h"

#include <algorithm>
#include <numeric>

namespace tissue
{
namespace
{
VertexQuadruple
Restored(const VertexQuadruple & t, const std::vector<VertexId> & order)
{
  return Canonical({ { order[t[0]], order[t[1]], order[t[2]], order[t[3]] } });
}

void
RestoreCorners(WallMesh & walls, const std::vector<VertexQuadruple> & tetrahedra, const std::vector<VertexId> & order)
{
  std::vector<VertexQuadruple> restored;
  restored.reserve(tetrahedra.size());
  for (const VertexQuadruple & t : tetrahedra)
  {
    restored.push_back(Restored(t, order));
  }
  std::vector<PointId> points(walls.points.size());
  std::iota(points.begin(), points.end(), PointId{ 0 });
  std::sort(points.begin(),
            points.begin() + static_cast<std::ptrdiff_t>(tetrahedra.size()),
            [&restored](PointId a, PointId b) { return restored[a] < restored[b]; });
  TakePoints(walls, points);
}
} // namespace

std::vector<VertexQuadruple>
RestoreVertices(std::vector<VertexQuadruple> tetrahedra, const std::vector<VertexId> & order)
{
  for (VertexQuadruple & t : tetrahedra)
  {
    t = Restored(t, order);
  }
  std::sort(tetrahedra.begin(), tetrahedra.end());
  return tetrahedra;
}

void
RestoreVertices(WallMesh & walls, const std::vector<VertexQuadruple> & tetrahedra, const std::vector<VertexId> & order)
{
  RestoreCorners(walls, tetrahedra, order);
  std::vector<unsigned char> isTurned(walls.walls.size(), 0);
  for (std::size_t w = 0; w < walls.walls.size(); ++w)
  {
    VertexPair & cells = walls.walls[w].cells;
    cells = { { order[cells[0]], order[cells[1]] } };
    if (cells[1] != ExteriorVertex && cells[0] > cells[1])
    {
      std::swap(cells[0], cells[1]);
      isTurned[w] = 1;
    }
  }
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    if (isTurned[walls.wallOfTriangle[t]] != 0)
    {
      std::swap(walls.triangles[t][1], walls.triangles[t][2]);
    }
  }
}
} // namespace tissue
