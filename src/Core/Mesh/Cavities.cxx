/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/Cavities.h"

#include "Common/Algorithms.h"
#include "TissueTessellationCore/Common/DisjointSets.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <map>

namespace tissue
{
namespace
{
using Triangles = std::vector<std::size_t>;

const VertexPair &
CellsOf(const WallMesh & mesh, std::size_t triangle)
{
  return mesh.walls[mesh.wallOfTriangle[triangle]].cells;
}

/** The triangles at the exterior that hang together at points. */
std::vector<Triangles>
CollectPieces(const WallMesh & mesh)
{
  const auto   isOfSurface = [&mesh](std::size_t t) { return CellsOf(mesh, t)[1] == ExteriorVertex; };
  DisjointSets sets(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & [a, b, c] = mesh.triangles[t];
    if (isOfSurface(t))
    {
      sets.Unite(a, b);
      sets.Unite(a, c);
    }
  }
  std::map<std::int64_t, Triangles> ofSet;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (isOfSurface(t))
    {
      ofSet[sets.Find(mesh.triangles[t][0])].push_back(t);
    }
  }
  std::vector<Triangles> pieces;
  for (auto & [set, triangles] : ofSet)
  {
    pieces.push_back(std::move(triangles));
  }
  return pieces;
}

bool
AreOfOneCell(const WallMesh & mesh, const Triangles & triangles)
{
  return std::all_of(triangles.begin(), triangles.end(), [&](std::size_t t) {
    return CellsOf(mesh, t)[0] == CellsOf(mesh, triangles.front())[0];
  });
}

/** Whether each edge of the triangles is there in both directions. */
bool
AreClosed(const WallMesh & mesh, const Triangles & triangles)
{
  std::vector<std::array<PointId, 2>> edges;
  for (const std::size_t t : triangles)
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

/** The volume on the side that the triangles' normals point to. */
double
VolumeInFront(const WallMesh & mesh, const Triangles & triangles)
{
  double        sixfold = 0.0;
  const Point & origin = mesh.points[mesh.triangles[triangles.front()][0]];
  for (const std::size_t t : triangles)
  {
    const auto & [a, b, c] = mesh.triangles[t];
    sixfold -= Dot(mesh.points[a] - origin, Cross(mesh.points[b] - origin, mesh.points[c] - origin));
  }
  return sixfold / 6.0;
}

Cavity
MakeCavity(const WallMesh & mesh, const Triangles & triangles, double volume)
{
  const Point & origin = mesh.points[mesh.triangles[triangles.front()][0]];
  Cavity        cavity{ CellsOf(mesh, triangles.front())[0], {}, { origin, origin }, volume };
  for (const std::size_t t : triangles)
  {
    cavity.walls.push_back(mesh.wallOfTriangle[t]);
    for (const PointId p : mesh.triangles[t])
    {
      Extend(cavity.box, mesh.points[p]);
    }
  }
  SortUnique(cavity.walls);
  return cavity;
}
} // namespace

std::vector<Cavity>
FindCavities(const WallMesh & mesh)
{
  std::vector<Cavity> cavities;
  for (const Triangles & piece : CollectPieces(mesh))
  {
    const double volume = AreOfOneCell(mesh, piece) ? VolumeInFront(mesh, piece) : 0.0;
    if (volume > 0.0 && AreClosed(mesh, piece))
    {
      cavities.push_back(MakeCavity(mesh, piece, volume));
    }
  }
  return cavities;
}
} // namespace tissue
