/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Statistics/TissueStatistics.h"

#include "Statistics/OuterSurface.h"
#include "Statistics/SolidMoments.h"
#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
/** Calls visit(cell, other side, wall) for both sides of every wall that has triangles. */
template <typename TVisit>
void
ForEachSide(const WallMesh & mesh, const std::vector<WallStatistics> & walls, const TVisit & visit)
{
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    if (walls[w].area > 0.0)
    {
      const VertexPair & cells = mesh.walls[w].cells;
      visit(cells[0], cells[1], w);
      visit(cells[1], cells[0], w);
    }
  }
}

WallStatistics
MeasureWall(const std::vector<SurfaceSample> & samples, const Point & normal, double area)
{
  WallStatistics wall;
  wall.area = area;
  Point center{ { 0.0, 0.0, 0.0 } };
  for (const SurfaceSample & sample : samples)
  {
    center = center + sample.area * sample.position;
  }
  if (!(wall.area > 0.0))
  {
    return wall;
  }
  wall.center = (1.0 / wall.area) * center;
  wall.planarity = Norm(normal) / wall.area;
  wall.planeDistance = MeasureRelief(samples, wall.center, Normalized(normal)).planeDistance;
  if (Norm(normal) > 0.0)
  {
    wall.normal = Normalized(normal);
    wall.meanCurvature = FitSurface(samples, wall.center, wall.normal).Mean();
  }
  return wall;
}

void
SetShape(const SolidMoments & solid, CellStatistics & cell)
{
  if (!(solid.volume > 0.0))
  {
    return;
  }
  const double pi = std::acos(-1.0);
  cell.sphericity = std::cbrt(36.0 * pi * solid.volume * solid.volume) / solid.area;
  const SymmetricEigen eigen = DecomposeSymmetric(solid.covariance);
  std::array<int, 3>   order{ { 0, 1, 2 } };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return eigen.values[a] > eigen.values[b]; });
  for (int i = 0; i < 3; ++i)
  {
    // A solid ellipsoid has a fifth of the square of its semi-axis for its variance along it.
    cell.axisLengths[i] = 2.0 * std::sqrt(5.0 * std::max(0.0, eigen.values[order[i]]));
    const Point & axis = eigen.vectors[order[i]];
    const auto    largest =
      std::max_element(axis.begin(), axis.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    cell.axes[i] = *largest < 0.0 ? -1.0 * axis : axis;
  }
}

/** Of each cell of the epidermis the curvatures about the largest of its walls at the tissue's surface; marks these
 * cells as the first layer. */
void
MeasureEpidermis(const OuterSurface & surface, const std::vector<double> & cellAreas,
                 std::vector<CellStatistics> & cells)
{
  constexpr double         leastShare = 0.02;
  constexpr std::size_t    none = static_cast<std::size_t>(-1);
  std::vector<double>      areas(cells.size(), 0.0);
  std::vector<std::size_t> largest(cells.size(), none);
  for (std::size_t w = 0; w < surface.walls.size(); ++w)
  {
    const OuterWall & wall = surface.walls[w];
    if (!wall.isCut)
    {
      areas[wall.cell] += wall.area;
      std::size_t & best = largest[wall.cell];
      best = best == none || wall.area > surface.walls[best].area ? w : best;
    }
  }
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    if (areas[v] > 0.0 && areas[v] >= leastShare * cellAreas[v])
    {
      cells[v].layer = 1;
      cells[v].curvatures = CurvaturesAround(surface, largest[v]);
    }
  }
}

/** Numbers the layers below the first. */
void
CountLayers(const WallMesh & mesh, const std::vector<WallStatistics> & walls, std::vector<CellStatistics> & cells)
{
  const CompressedRows<VertexId> neighbors(cells.size(), [&](const auto & add) {
    ForEachSide(mesh, walls, [&](VertexId cell, VertexId other, std::size_t) { add(cell, other); });
  });
  std::vector<VertexId>          layer;
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    if (cells[v].layer == 1)
    {
      layer.push_back(static_cast<VertexId>(v));
    }
  }
  for (std::int32_t number = 2; !layer.empty(); ++number)
  {
    std::vector<VertexId> next;
    for (const VertexId v : layer)
    {
      for (const VertexId neighbor : neighbors[v])
      {
        if (neighbor != ExteriorVertex && cells[neighbor].layer == 0)
        {
          cells[neighbor].layer = number;
          next.push_back(neighbor);
        }
      }
    }
    layer = std::move(next);
  }
}
} // namespace

std::vector<WallStatistics>
MeasureWalls(const WallMesh & mesh)
{
  const CompressedRows<std::size_t> trianglesOf(mesh.walls.size(), [&mesh](const auto & add) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      add(mesh.wallOfTriangle[t], t);
    }
  });
  std::vector<WallStatistics>       walls;
  std::vector<SurfaceSample>        samples;
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    samples.clear();
    double area = 0.0;
    Point  normal{ { 0.0, 0.0, 0.0 } };
    for (const std::size_t t : trianglesOf[w])
    {
      const Triangle & triangle = mesh.triangles[t];
      const Point &    a = mesh.points[triangle[0]];
      const Point      half = 0.5 * Cross(mesh.points[triangle[1]] - a, mesh.points[triangle[2]] - a);
      normal = normal + half;
      area += Norm(half);
      for (const PointId p : triangle)
      {
        samples.push_back({ mesh.points[p], Norm(half) / 3.0 });
      }
    }
    walls.push_back(MeasureWall(samples, normal, area));
  }
  return walls;
}

TissueStatistics
MeasureTissue(const WallMesh & mesh, const std::vector<Cell> & cells, const ImageGrid & grid)
{
  RequireConsistentIndices(mesh, static_cast<VertexId>(cells.size()));
  TissueStatistics statistics;
  statistics.walls = MeasureWalls(mesh);
  statistics.cells.resize(cells.size());
  const std::vector<SolidMoments> solids = MeasureSolids(mesh, cells.size());
  std::vector<double>             areas;
  for (std::size_t v = 0; v < cells.size(); ++v)
  {
    areas.push_back(solids[v].area);
    SetShape(solids[v], statistics.cells[v]);
  }
  const OuterSurface surface = FindOuterSurface(mesh, cells, areas, grid);
  ForEachSide(mesh, statistics.walls, [&](VertexId cell, VertexId other, std::size_t w) {
    if (other == ExteriorVertex)
    {
      statistics.walls[w].cutArea = surface.cutAreas[w];
      statistics.cells[cell].exteriorArea += statistics.walls[w].area;
      statistics.cells[cell].cutArea += surface.cutAreas[w];
    }
  });
  MeasureEpidermis(surface, areas, statistics.cells);
  CountLayers(mesh, statistics.walls, statistics.cells);
  return statistics;
}
} // namespace tissue
