/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/LabelledTriangles.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace tissue
{
namespace
{
using Triangle = LabelledTriangles::Triangle;

Triangle
Orient(Triangle triangle)
{
  const bool isExteriorFirst = triangle.cells[0] == ExteriorVertex;
  const bool isExteriorSecond = triangle.cells[1] == ExteriorVertex;
  if (isExteriorFirst || (!isExteriorSecond && triangle.cells[0] > triangle.cells[1]))
  {
    std::swap(triangle.cells[0], triangle.cells[1]);
    std::swap(triangle.points[1], triangle.points[2]);
  }
  return triangle;
}

void
Check(const LabelledTriangles & mesh)
{
  const auto numberOfPoints = static_cast<PointId>(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle & triangle = mesh.triangles[t];
    if (triangle.cells[0] == triangle.cells[1])
    {
      throw std::invalid_argument("triangle " + std::to_string(t) + " has cell " + std::to_string(triangle.cells[0]) +
                                  " on both sides");
    }
    for (const PointId p : triangle.points)
    {
      if (p < 0 || p >= numberOfPoints)
      {
        throw std::invalid_argument("triangle " + std::to_string(t) + " has point " + std::to_string(p) +
                                    ", must be at least 0 and below " + std::to_string(numberOfPoints));
      }
    }
  }
}
} // namespace

WallMesh
MakeWallMesh(const LabelledTriangles & mesh)
{
  Check(mesh);
  std::vector<Triangle> triangles(mesh.triangles.size());
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), triangles.begin(), Orient);
  std::stable_sort(
    triangles.begin(), triangles.end(), [](const Triangle & a, const Triangle & b) { return a.cells < b.cells; });

  constexpr PointId    unused = -1;
  std::vector<PointId> newIds(mesh.points.size(), unused);
  for (const Triangle & triangle : triangles)
  {
    for (const PointId p : triangle.points)
    {
      newIds[p] = 0;
    }
  }
  WallMesh result;
  for (std::size_t p = 0; p < newIds.size(); ++p)
  {
    if (newIds[p] != unused)
    {
      newIds[p] = static_cast<PointId>(result.points.size());
      result.points.push_back(mesh.points[p]);
    }
  }
  for (const Triangle & triangle : triangles)
  {
    if (result.walls.empty() || result.walls.back().cells != triangle.cells)
    {
      result.walls.push_back({ triangle.cells });
    }
    const std::array<PointId, 3> & p = triangle.points;
    result.triangles.push_back({ { newIds[p[0]], newIds[p[1]], newIds[p[2]] } });
    result.wallOfTriangle.push_back(static_cast<WallId>(result.walls.size() - 1));
  }
  return result;
}
} // namespace tissue
