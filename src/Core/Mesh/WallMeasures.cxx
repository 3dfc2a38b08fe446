/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallMeasures.h"

#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue
{
double
ComputeArea(const WallMesh & mesh)
{
  double area = 0.0;
  for (const Triangle & t : mesh.triangles)
  {
    area += TriangleArea(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  }
  return area;
}

std::vector<double>
ComputeWallAreas(const WallMesh & mesh)
{
  std::vector<double> areas(mesh.walls.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle & triangle = mesh.triangles[t];
    areas[mesh.wallOfTriangle[t]] +=
      TriangleArea(mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]);
  }
  return areas;
}

std::vector<double>
ComputeVolumes(const WallMesh & mesh, std::size_t numberOfVertices)
{
  std::vector<double> volumes(numberOfVertices, 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & triangle = mesh.triangles[t];
    const auto & origin = mesh.points.front();
    const double volume = Dot(mesh.points[triangle[0]] - origin,
                              Cross(mesh.points[triangle[1]] - origin, mesh.points[triangle[2]] - origin)) /
                          6.0;
    const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    volumes[cells[0]] += volume;
    volumes[cells[1]] -= volume;
  }
  volumes[ExteriorVertex] = 0.0;
  return volumes;
}
} // namespace tissue
