/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Statistics/OuterTriangles.h"

#include "TissueTessellationCore/Common/DisjointSets.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
/** The cell of a triangle at the exterior; the exterior where it is between two cells. */
VertexId
CellAtExterior(const WallMesh & mesh, std::size_t t)
{
  const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
  return cells[0] == ExteriorVertex ? cells[1] : cells[1] == ExteriorVertex ? cells[0] : ExteriorVertex;
}

/** Six times the volume between a triangle at the exterior and a point, positive where the point is behind it. */
double
VolumeBehind(const WallMesh & mesh, std::size_t t, const Point & origin)
{
  const Triangle & triangle = mesh.triangles[t];
  const double     volume =
    Dot(mesh.points[triangle[0]] - origin, Cross(mesh.points[triangle[1]] - origin, mesh.points[triangle[2]] - origin));
  return mesh.walls[mesh.wallOfTriangle[t]].cells[0] == ExteriorVertex ? -volume : volume;
}

bool
IsNear(const Point & p, const CutPlane & plane)
{
  return std::abs(Dot(p, plane.normal) - plane.offset) <= plane.tolerance;
}

/** Whether each point of a triangle is near one of the planes, and it is about parallel to such a one. Across the edge
 * of two planes triangles have points on both. */
bool
IsCut(const std::vector<CutPlane> & planes, const WallMesh & mesh, const Triangle & triangle)
{
  constexpr double leastCosine = 0.5;
  const Point &    a = mesh.points[triangle[0]];
  const Point      normal = Normalized(Cross(mesh.points[triangle[1]] - a, mesh.points[triangle[2]] - a));
  bool             isParallel = false;
  for (const PointId p : triangle)
  {
    bool isNear = false;
    for (const CutPlane & plane : planes)
    {
      if (IsNear(mesh.points[p], plane))
      {
        isNear = true;
        isParallel = isParallel || std::abs(Dot(normal, plane.normal)) >= leastCosine;
      }
    }
    if (!isNear)
    {
      return false;
    }
  }
  return isParallel;
}
} // namespace

std::vector<CutPlane>
FindBorder(const ImageGrid & grid)
{
  constexpr double      voxels = 1.5;
  std::vector<CutPlane> border;
  for (int axis = 0; axis < 3 && grid.size[axis] > 0; ++axis)
  {
    const Point  normal = Normalized(Cross(grid.steps[(axis + 1) % 3], grid.steps[(axis + 2) % 3]));
    const double step = Dot(grid.steps[axis], normal);
    const double first = Dot(grid.origin, normal) - 0.5 * step;
    border.push_back({ normal, first, voxels * std::abs(step) });
    border.push_back({ normal, first + step * grid.size[axis], voxels * std::abs(step) });
  }
  return border;
}

std::vector<TrianglePlace>
FindSurface(const WallMesh & mesh)
{
  DisjointSets parts(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (CellAtExterior(mesh, t) != ExteriorVertex)
    {
      parts.Unite(mesh.triangles[t][0], mesh.triangles[t][1]);
      parts.Unite(mesh.triangles[t][0], mesh.triangles[t][2]);
    }
  }
  std::vector<double> volumes(mesh.points.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (CellAtExterior(mesh, t) != ExteriorVertex)
    {
      const auto part = parts.Find(mesh.triangles[t][0]);
      volumes[part] += VolumeBehind(mesh, t, mesh.points[part]);
    }
  }
  std::vector<TrianglePlace> places(mesh.triangles.size(), TrianglePlace::Within);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const bool isOuter = CellAtExterior(mesh, t) != ExteriorVertex && volumes[parts.Find(mesh.triangles[t][0])] > 0.0;
    places[t] = isOuter ? TrianglePlace::Surface : TrianglePlace::Within;
  }
  return places;
}

void
MarkCut(const WallMesh & mesh, const std::vector<CutPlane> & planes, const std::function<bool(VertexId)> & mayBeCut,
        std::vector<TrianglePlace> & places)
{
  for (std::size_t t = 0; t < places.size(); ++t)
  {
    if (places[t] == TrianglePlace::Surface && mayBeCut(CellAtExterior(mesh, t)) &&
        IsCut(planes, mesh, mesh.triangles[t]))
    {
      places[t] = TrianglePlace::Cut;
    }
  }
}
} // namespace tissue
