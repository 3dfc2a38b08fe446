/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/Cavities.h"

#include "Mesh/WallPieces.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** Whether each edge of the triangles is there in both directions. */
bool
IsClosed(const WallMesh & mesh, std::size_t begin, std::size_t end)
{
  std::vector<std::array<PointId, 2>> edges;
  for (std::size_t t = begin; t < end; ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.push_back({ { mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3] } });
    }
  }
  std::sort(edges.begin(), edges.end());
  return std::all_of(edges.begin(), edges.end(), [&](const std::array<PointId, 2> & edge) {
    return std::binary_search(edges.begin(), edges.end(), std::array<PointId, 2>{ { edge[1], edge[0] } });
  });
}

/** Six times the volume within the triangles, negative where their normals point inwards. */
double
SignedVolume(const WallMesh & mesh, std::size_t begin, std::size_t end)
{
  double        sum = 0.0;
  const Point & origin = mesh.points[mesh.triangles[begin][0]];
  for (std::size_t t = begin; t < end; ++t)
  {
    const auto & [a, b, c] = mesh.triangles[t];
    sum += Dot(mesh.points[a] - origin, Cross(mesh.points[b] - origin, mesh.points[c] - origin));
  }
  return sum;
}
} // namespace

std::vector<VertexId>
FindCavities(const WallMesh & mesh)
{
  std::vector<VertexId>          cells;
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(mesh);
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    if (mesh.walls[w].cells[1] == ExteriorVertex && first[w] < first[w + 1] &&
        SignedVolume(mesh, first[w], first[w + 1]) < 0.0 && IsClosed(mesh, first[w], first[w + 1]))
    {
      cells.push_back(mesh.walls[w].cells[0]);
    }
  }
  return cells;
}
} // namespace tissue
