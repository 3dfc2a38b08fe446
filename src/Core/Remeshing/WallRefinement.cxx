/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/WallRefinement.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** An edge of the mesh, ascending, and how many triangles share it: 2 within a wall, 3 on a triple line. */
struct MeshEdge
{
  std::array<PointId, 2> points;
  int                    numberOfTriangles;
};

std::array<PointId, 2>
EdgeOf(const Triangle & triangle, int i)
{
  const PointId a = triangle[i];
  const PointId b = triangle[(i + 1) % 3];
  return { { std::min(a, b), std::max(a, b) } };
}

std::vector<MeshEdge>
CollectEdges(const WallMesh & mesh)
{
  std::vector<std::array<PointId, 2>> all;
  all.reserve(3 * mesh.triangles.size());
  for (const auto & triangle : mesh.triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      all.push_back(EdgeOf(triangle, i));
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<MeshEdge> edges;
  for (const auto & points : all)
  {
    if (edges.empty() || edges.back().points != points)
    {
      edges.push_back({ points, 0 });
    }
    ++edges.back().numberOfTriangles;
  }
  return edges;
}
} // namespace

void
SplitTriangles(WallMesh & mesh)
{
  // Each edge gets a point at its middle, whose number follows from the edge's place in the sorted list; each triangle
  // becomes the three at its corners and the one between its middles.
  const std::vector<MeshEdge> edges = CollectEdges(mesh);
  const auto                  firstMiddle = static_cast<PointId>(mesh.points.size());
  for (const MeshEdge & edge : edges)
  {
    mesh.points.push_back(0.5 * (mesh.points[edge.points[0]] + mesh.points[edge.points[1]]));
    mesh.numberOfCells.push_back(edge.numberOfTriangles > 2 ? CellsOnLine : CellsWithinWall);
  }
  const auto middleOf = [&](const Triangle & triangle, int i) {
    const auto at = std::lower_bound(
      edges.begin(),
      edges.end(),
      EdgeOf(triangle, i),
      [](const MeshEdge & edge, const std::array<PointId, 2> & points) { return edge.points < points; });
    return firstMiddle + static_cast<PointId>(at - edges.begin());
  };
  std::vector<Triangle> triangles;
  std::vector<WallId>   wallOfTriangle;
  triangles.reserve(4 * mesh.triangles.size());
  wallOfTriangle.reserve(4 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto &                 old = mesh.triangles[t];
    const std::array<PointId, 3> middles{ { middleOf(old, 0), middleOf(old, 1), middleOf(old, 2) } };
    triangles.push_back({ { old[0], middles[0], middles[2] } });
    triangles.push_back({ { middles[0], old[1], middles[1] } });
    triangles.push_back({ { middles[2], middles[1], old[2] } });
    triangles.push_back(middles);
    wallOfTriangle.insert(wallOfTriangle.end(), 4, mesh.wallOfTriangle[t]);
  }
  mesh.triangles = std::move(triangles);
  mesh.wallOfTriangle = std::move(wallOfTriangle);
}

void
SmoothWalls(WallMesh & mesh, int numberOfIterations)
{
  // The shares of the way to the mean of the neighbours that points go, in turn. Their 1 / 0.5 - 1 / 0.53 = 0.11 is the
  // filter's pass-band frequency, up to which waves stay; Taubin found 0.01 to 0.1 to be good.
  constexpr double            forward = 0.5;
  constexpr double            backward = -0.53;
  const std::vector<MeshEdge> edges = CollectEdges(mesh);
  // A point follows its neighbours along edges that meet at least as many cells as the point does.
  const auto follows = [&mesh](PointId point, const MeshEdge & edge) {
    return mesh.numberOfCells[point] == CellsWithinWall ||
           (mesh.numberOfCells[point] == CellsOnLine && edge.numberOfTriangles > 2);
  };
  std::vector<Point> sums(mesh.points.size());
  std::vector<int>   counts(mesh.points.size());
  for (int step = 0; step < 2 * numberOfIterations; ++step)
  {
    std::fill(sums.begin(), sums.end(), Point{ { 0.0, 0.0, 0.0 } });
    std::fill(counts.begin(), counts.end(), 0);
    for (const MeshEdge & edge : edges)
    {
      for (int side = 0; side < 2; ++side)
      {
        const PointId point = edge.points[side];
        if (follows(point, edge))
        {
          sums[point] = sums[point] + mesh.points[edge.points[1 - side]];
          ++counts[point];
        }
      }
    }
    const double factor = step % 2 == 0 ? forward : backward;
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      if (counts[p] > 0 && mesh.numberOfCells[p] < CellsAtCorner)
      {
        mesh.points[p] = mesh.points[p] + factor * ((1.0 / counts[p]) * sums[p] - mesh.points[p]);
      }
    }
  }
}
} // namespace tissue
