/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Statistics/OuterSurface.h"

#include "Common/Algorithms.h"
#include "Statistics/CutWalls.h"
#include "Statistics/OuterTriangles.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <cmath>

namespace tissue
{
namespace
{
constexpr std::size_t NoWall = static_cast<std::size_t>(-1);

/** Twice the area of a triangle times its normal, away from the wall's cell that is not the exterior. */
Point
OutwardNormal(const WallMesh & mesh, std::size_t t)
{
  const Triangle & triangle = mesh.triangles[t];
  const Point &    a = mesh.points[triangle[0]];
  const Point      normal = Cross(mesh.points[triangle[1]] - a, mesh.points[triangle[2]] - a);
  return mesh.walls[mesh.wallOfTriangle[t]].cells[0] == ExteriorVertex ? -1.0 * normal : normal;
}

/** Calls visit(triangle, outer wall) for the triangles of outer walls. */
template <typename TVisit>
void
ForEachTriangle(const WallMesh & mesh, const std::vector<TrianglePlace> & places,
                const std::vector<std::size_t> & outerOfWall, const TVisit & visit)
{
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (places[t] == TrianglePlace::Surface)
    {
      visit(t, outerOfWall[mesh.wallOfTriangle[t]]);
    }
  }
}

/** The outer walls that share an edge, each pair in both directions, ascending. */
std::vector<std::array<std::size_t, 2>>
FindNeighbors(const WallMesh & mesh, const std::vector<TrianglePlace> & places,
              const std::vector<std::size_t> & outerOfWall)
{
  struct Side
  {
    std::array<PointId, 2> edge;
    std::size_t            wall;
  };
  std::vector<Side> sides;
  ForEachTriangle(mesh, places, outerOfWall, [&](std::size_t t, std::size_t outer) {
    const Triangle & triangle = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto ends = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      sides.push_back({ { { ends.first, ends.second } }, outer });
    }
  });
  std::sort(sides.begin(), sides.end(), [](const Side & a, const Side & b) {
    return a.edge != b.edge ? a.edge < b.edge : a.wall < b.wall;
  });
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 1; i < sides.size(); ++i)
  {
    if (sides[i].edge == sides[i - 1].edge && sides[i].wall != sides[i - 1].wall)
    {
      pairs.push_back({ { sides[i - 1].wall, sides[i].wall } });
      pairs.push_back({ { sides[i].wall, sides[i - 1].wall } });
    }
  }
  SortUnique(pairs);
  return pairs;
}

/** The points of each outer wall by the areas around them, without those that planes cut, whose edges are rounded. */
CompressedRows<SurfaceSample>
CollectSamples(const WallMesh & mesh, const std::vector<TrianglePlace> & places,
               const std::vector<std::size_t> & outerOfWall, std::size_t numberOfWalls)
{
  std::vector<bool> isCut(mesh.points.size(), false);
  for (std::size_t t = 0; t < places.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      isCut[p] = isCut[p] || places[t] == TrianglePlace::Cut;
    }
  }
  return CompressedRows<SurfaceSample>(numberOfWalls, [&](const auto & add) {
    ForEachTriangle(mesh, places, outerOfWall, [&](std::size_t t, std::size_t outer) {
      const double area = 0.5 * Norm(OutwardNormal(mesh, t));
      for (const PointId p : mesh.triangles[t])
      {
        if (!isCut[p])
        {
          add(outer, SurfaceSample{ mesh.points[p], area / 3.0 });
        }
      }
    });
  });
}

/** Numbers the walls of the surface, and adds up what they are made of. */
std::vector<OuterWall>
SumWalls(const WallMesh & mesh, const std::vector<TrianglePlace> & places, const std::vector<double> & cellAreas,
         std::vector<std::size_t> & outerOfWall)
{
  const double           pi = std::acos(-1.0);
  std::vector<OuterWall> walls;
  for (std::size_t t = 0; t < places.size(); ++t)
  {
    outerOfWall[mesh.wallOfTriangle[t]] = places[t] == TrianglePlace::Surface ? 0 : outerOfWall[mesh.wallOfTriangle[t]];
  }
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    if (outerOfWall[w] != NoWall)
    {
      const VertexPair & cells = mesh.walls[w].cells;
      OuterWall          wall;
      wall.wall = static_cast<WallId>(w);
      wall.cell = cells[0] == ExteriorVertex ? cells[1] : cells[0];
      wall.diameter = std::sqrt(cellAreas[wall.cell] / pi);
      outerOfWall[w] = walls.size();
      walls.push_back(wall);
    }
  }
  ForEachTriangle(mesh, places, outerOfWall, [&](std::size_t t, std::size_t outer) {
    const Point  normal = OutwardNormal(mesh, t);
    const double area = 0.5 * Norm(normal);
    OuterWall &  wall = walls[outer];
    wall.area += area;
    wall.normal = wall.normal + 0.5 * normal;
    for (const PointId p : mesh.triangles[t])
    {
      wall.center = wall.center + area / 3.0 * mesh.points[p];
    }
  });
  for (OuterWall & wall : walls)
  {
    wall.center = (wall.area > 0.0 ? 1.0 / wall.area : 0.0) * wall.center;
  }
  return walls;
}
OuterSurface
MakeSurface(const WallMesh & mesh, const std::vector<TrianglePlace> & places, const std::vector<double> & cellAreas)
{
  std::vector<std::size_t> outerOfWall(mesh.walls.size(), NoWall);
  OuterSurface             surface;
  surface.walls = SumWalls(mesh, places, cellAreas, outerOfWall);
  const auto pairs = FindNeighbors(mesh, places, outerOfWall);
  surface.neighbors.Assign(surface.walls.size(), [&](const auto & add) {
    for (const auto & pair : pairs)
    {
      add(pair[0], pair[1]);
    }
  });
  surface.samples = CollectSamples(mesh, places, outerOfWall, surface.walls.size());
  return surface;
}

double
SumAreas(const OuterSurface & surface)
{
  double area = 0.0;
  for (const OuterWall & wall : surface.walls)
  {
    area += wall.area;
  }
  return area;
}

/** That of the tissue, with what is cut. */
double
SumAreas(const WallMesh & mesh, const std::vector<TrianglePlace> & places)
{
  double area = 0.0;
  for (std::size_t t = 0; t < places.size(); ++t)
  {
    area += places[t] == TrianglePlace::Within ? 0.0 : 0.5 * Norm(OutwardNormal(mesh, t));
  }
  return area;
}

/** Takes what is left of a tissue that is cut all around, as a rounded corner of the image, for cut, too. */
void
MarkRemainder(double areaOfTissue, OuterSurface & surface)
{
  constexpr double leastShare = 0.02;
  double           left = 0.0;
  for (const OuterWall & wall : surface.walls)
  {
    left += wall.isCut ? 0.0 : wall.area;
  }
  for (OuterWall & wall : surface.walls)
  {
    wall.isCut = wall.isCut || left < leastShare * areaOfTissue;
  }
}

/** The areas that are cut, by wall. */
std::vector<double>
SumCutAreas(const WallMesh & mesh, const std::vector<TrianglePlace> & places, const std::vector<OuterWall> & walls)
{
  std::vector<double> areas(mesh.walls.size(), 0.0);
  for (std::size_t t = 0; t < places.size(); ++t)
  {
    areas[mesh.wallOfTriangle[t]] += places[t] == TrianglePlace::Cut ? 0.5 * Norm(OutwardNormal(mesh, t)) : 0.0;
  }
  for (const OuterWall & wall : walls)
  {
    areas[wall.wall] += wall.isCut ? wall.area : 0.0;
  }
  return areas;
}
/** The wall and those next to it by which the surface there is judged. */
std::vector<std::size_t>
WallsAround(const OuterSurface & surface, std::size_t wall)
{
  constexpr double         leastCosine = 0.3;
  const OuterWall &        middle = surface.walls[wall];
  std::vector<std::size_t> around{ wall };
  for (const std::size_t neighbor : surface.neighbors[wall])
  {
    const OuterWall & other = surface.walls[neighbor];
    const bool        facesAway = Dot(Normalized(middle.normal), Normalized(other.normal)) < leastCosine;
    if (!facesAway && (middle.isCut || !other.isCut))
    {
      around.push_back(neighbor);
    }
  }
  return around;
}
} // namespace

OuterSurface
FindOuterSurface(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<double> & cellAreas,
                 const ImageGrid & grid)
{
  constexpr double leastLeft = 0.5;
  // Planes leave a surface with less that could be one, or rough: the border first, then others, then what is rough.
  std::vector<TrianglePlace> places = FindSurface(mesh);
  MarkCut(
    mesh, FindBorder(grid), [&cells](VertexId cell) { return cells[cell].touchesBorder; }, places);
  OuterSurface               surface = MakeSurface(mesh, places, cellAreas);
  const double               voxelLength = std::cbrt(std::abs(Dot(grid.steps[0], Cross(grid.steps[1], grid.steps[2]))));
  const auto                 planes = FindCutPlanes(surface, grid.size[0] > 0 ? voxelLength : 0.0);
  std::vector<TrianglePlace> withPlanes = places;
  MarkCut(
    mesh, planes, [](VertexId) { return true; }, withPlanes);
  OuterSurface left = MakeSurface(mesh, withPlanes, cellAreas);
  if (SumAreas(left) >= leastLeft * SumAreas(surface))
  {
    places = std::move(withPlanes);
    surface = std::move(left);
  }
  MarkCutWalls(surface);
  MarkRemainder(SumAreas(mesh, places), surface);
  surface.cutAreas = SumCutAreas(mesh, places, surface.walls);
  return surface;
}

SurfaceRelief
ReliefAround(const OuterSurface & surface, std::size_t wall)
{
  std::vector<SurfaceSample> samples;
  Point                      normal{ { 0.0, 0.0, 0.0 } };
  for (const std::size_t w : WallsAround(surface, wall))
  {
    const auto ofWall = surface.samples[w];
    samples.insert(samples.end(), ofWall.begin(), ofWall.end());
    normal = normal + surface.walls[w].normal;
  }
  return MeasureRelief(samples, surface.walls[wall].center, Normalized(normal));
}

Curvatures
CurvaturesAround(const OuterSurface & surface, std::size_t wall)
{
  std::vector<SurfacePart> parts;
  Point                    normal{ { 0.0, 0.0, 0.0 } };
  for (const std::size_t w : WallsAround(surface, wall))
  {
    const OuterWall & part = surface.walls[w];
    parts.push_back({ part.center, part.normal, part.area });
    normal = normal + part.normal;
  }
  return FitNormals(parts, surface.walls[wall].center, Normalized(normal));
}
} // namespace tissue
