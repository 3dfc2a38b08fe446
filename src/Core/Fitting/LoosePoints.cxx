/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/LoosePoints.h"

#include "Geometry/BoxGrid.h"
#include "Geometry/TriangleCrossing.h"

#include <map>

namespace tissue
{
namespace
{
/** Finds the triangles that each loose point's own can come to cross while all loose points stay within their reach.
 *
 * These are the triangles whose box, extended by the reach of their own loose points, overlaps the point's reach. One
 * grid holds the boxes of all triangles, a group among which no pairs are asked for, and, after them, the reaches. */
void
FindClose(const WallMesh & mesh, std::vector<LoosePoint> & loose)
{
  const auto                 numberOfTriangles = static_cast<std::int32_t>(mesh.triangles.size());
  std::map<std::size_t, Box> extended;
  std::vector<std::int32_t>  groups(mesh.triangles.size(), 0);
  for (const LoosePoint & entry : loose)
  {
    for (const std::int32_t t : entry.triangles)
    {
      Box & box = extended.emplace(t, BoxOfTriangle(mesh.points, mesh.triangles[t])).first->second;
      Extend(box, entry.reach.lower);
      Extend(box, entry.reach.upper);
    }
    groups.push_back(groups.back() + 1);
  }
  const auto boxOf = [&](std::size_t i) {
    if (i >= mesh.triangles.size())
    {
      return loose[i - mesh.triangles.size()].reach;
    }
    const auto found = extended.find(i);
    return found != extended.end() ? found->second : BoxOfTriangle(mesh.points, mesh.triangles[i]);
  };
  const BoxGrid grid(mesh.triangles.size() + loose.size(), boxOf, std::move(groups));
  for (std::int64_t layer = 0; layer < grid.NumberOfLayers(); ++layer)
  {
    grid.VisitPairs(layer, [&](std::int32_t a, std::int32_t b) {
      if (a < numberOfTriangles && b >= numberOfTriangles)
      {
        loose[b - numberOfTriangles].close.push_back(a);
      }
    });
  }
}
} // namespace

std::vector<LoosePoint>
CollectLoosePoints(const WallMesh & mesh, const std::set<PointId> & points)
{
  std::map<PointId, LoosePoint> loose;
  for (const PointId p : points)
  {
    loose[p].point = p;
    loose[p].reach = { mesh.points[p], mesh.points[p] };
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      const auto at = loose.find(p);
      if (at == loose.end())
      {
        continue;
      }
      at->second.triangles.push_back(static_cast<std::int32_t>(t));
      for (const PointId q : mesh.triangles[t])
      {
        Extend(at->second.reach, mesh.points[q]);
        if (q != p)
        {
          at->second.neighbors.push_back(q);
        }
      }
    }
  }
  std::vector<LoosePoint> result;
  for (auto & [p, entry] : loose)
  {
    result.push_back(std::move(entry));
  }
  FindClose(mesh, result);
  return result;
}

int
CountCrossings(const WallMesh & mesh, const LoosePoint & entry)
{
  int count = 0;
  for (const std::int32_t t : entry.triangles)
  {
    const auto & triangle = mesh.triangles[t];
    const Box    box = BoxOfTriangle(mesh.points, triangle);
    for (const std::int32_t other : entry.close)
    {
      const auto & o = mesh.triangles[other];
      count +=
        other != t && Overlap(box, BoxOfTriangle(mesh.points, o)) && TrianglesCross(mesh.points, triangle, o) ? 1 : 0;
    }
  }
  return count;
}
} // namespace tissue
