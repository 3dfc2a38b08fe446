/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Simulation/CellSolids.h"

#include "TissueTessellationCore/Common/DisjointSets.h"
#include "TissueTessellationCore/Geometry/Box.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace tissue
{
namespace
{
/** A triangle of a cell's surface, turned outwards. */
struct Side
{
  std::array<PointId, 3> points;
  WallId                 wall;
};

/** Triangles that hang together by edges. */
struct Surface
{
  std::vector<Side>   sides;
  std::vector<WallId> walls;
  double              volume = 0.0;
  Box                 box;
};

/** The triangles of each vertex, turned away from it. */
std::vector<std::vector<Side>>
CollectSides(const WallMesh & mesh, std::size_t numberOfVertices)
{
  std::vector<std::vector<Side>> sides(numberOfVertices);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & [a, b, c] = mesh.triangles[t];
    const WallId       wall = mesh.wallOfTriangle[t];
    const VertexPair & cells = mesh.walls[static_cast<std::size_t>(wall)].cells;
    sides[static_cast<std::size_t>(cells[0])].push_back({ { { a, b, c } }, wall });
    sides[static_cast<std::size_t>(cells[1])].push_back({ { { a, c, b } }, wall });
  }
  return sides;
}

using Edge = std::pair<PointId, PointId>;

/** Whether as many sides run along each edge one way as the other. */
bool
AreClosed(const std::vector<Side> & sides)
{
  std::map<Edge, int> balances;
  for (const Side & side : sides)
  {
    for (int i = 0; i < 3; ++i)
    {
      const PointId from = side.points[i];
      const PointId to = side.points[(i + 1) % 3];
      balances[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return std::all_of(balances.begin(), balances.end(), [](const auto & edge) { return edge.second == 0; });
}

void
Measure(const WallMesh & mesh, Surface & surface)
{
  const Point origin = mesh.points[surface.sides.front().points[0]];
  surface.box = { origin, origin };
  for (const Side & side : surface.sides)
  {
    const Point & a = mesh.points[side.points[0]];
    const Point & b = mesh.points[side.points[1]];
    const Point & c = mesh.points[side.points[2]];
    surface.volume += Dot(a - origin, Cross(b - origin, c - origin)) / 6.0;
    Extend(surface.box, a);
    Extend(surface.box, b);
    Extend(surface.box, c);
    surface.walls.push_back(side.wall);
  }
  std::sort(surface.walls.begin(), surface.walls.end());
  surface.walls.erase(std::unique(surface.walls.begin(), surface.walls.end()), surface.walls.end());
}

/** In the order of their first triangles. */
std::vector<Surface>
TakeApart(const WallMesh & mesh, const std::vector<Side> & sides)
{
  DisjointSets                sets(sides.size());
  std::map<Edge, std::size_t> firstOfEdge;
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Edge edge = std::minmax(sides[s].points[i], sides[s].points[(i + 1) % 3]);
      const auto first = firstOfEdge.emplace(edge, s).first->second;
      sets.Unite(static_cast<std::int64_t>(first), static_cast<std::int64_t>(s));
    }
  }
  std::map<std::int64_t, Surface> ofSet;
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    ofSet[sets.Find(static_cast<std::int64_t>(s))].sides.push_back(sides[s]);
  }
  std::vector<Surface> surfaces;
  for (auto & [set, surface] : ofSet)
  {
    Measure(mesh, surface);
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

bool
Holds(const Box & outer, const Box & inner)
{
  for (int i = 0; i < 3; ++i)
  {
    if (inner.lower[i] < outer.lower[i] || inner.upper[i] > outer.upper[i])
    {
      return false;
    }
  }
  return true;
}

/** How far along a ray a triangle is, in lengths of the direction (T. Moeller and B. Trumbore 1997,
 * doi:10.1080/10867651.1997.10487468); nothing where the ray passes it by. */
std::optional<double>
FindHit(const Point & start, const Point & direction, const Point & a, const Point & b, const Point & c)
{
  const Point  ab = b - a;
  const Point  ac = c - a;
  const Point  p = Cross(direction, ac);
  const double determinant = Dot(ab, p);
  const Point  toStart = start - a;
  const Point  q = Cross(toStart, ab);
  const double u = Dot(toStart, p) / determinant;
  const double v = Dot(direction, q) / determinant;
  const double distance = Dot(ac, q) / determinant;
  const bool   isHit = determinant != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0;
  return isHit ? std::optional<double>(distance) : std::nullopt;
}

/** A point within: halfway from the middle of the largest triangle of the outer surface to what is hit inwards. */
Point
FindInside(const WallMesh & mesh, const std::vector<const Surface *> & surfaces)
{
  const auto normal = [&mesh](const Side & side) {
    const Point & a = mesh.points[side.points[0]];
    return Cross(mesh.points[side.points[1]] - a, mesh.points[side.points[2]] - a);
  };
  const std::vector<Side> & outer = surfaces.front()->sides;
  const auto                largest = std::max_element(outer.begin(), outer.end(), [&](const Side & a, const Side & b) {
    return Dot(normal(a), normal(a)) < Dot(normal(b), normal(b));
  });
  const Point               inwards = -1.0 * normal(*largest);
  Point                     middle{ { 0.0, 0.0, 0.0 } };
  for (const PointId p : largest->points)
  {
    middle = middle + (1.0 / 3.0) * mesh.points[p];
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const Surface * surface : surfaces)
  {
    for (const Side & side : surface->sides)
    {
      const auto hit =
        side.points == largest->points
          ? std::nullopt
          : FindHit(
              middle, inwards, mesh.points[side.points[0]], mesh.points[side.points[1]], mesh.points[side.points[2]]);
      nearest = std::min(nearest, hit.value_or(nearest));
    }
  }
  return std::isfinite(nearest) ? middle + (0.5 * nearest) * inwards : middle;
}

/** The solids of one vertex. */
std::vector<CellSolid>
MakeSolids(const WallMesh & mesh, VertexId cell, const std::vector<Surface> & surfaces)
{
  // Those within others after these.
  std::vector<std::vector<const Surface *>> ofSolid;
  for (const Surface & surface : surfaces)
  {
    if (surface.volume > 0.0)
    {
      ofSolid.push_back({ &surface });
    }
  }
  for (const Surface & surface : surfaces)
  {
    std::vector<const Surface *> * around = nullptr;
    for (std::vector<const Surface *> & solid : ofSolid)
    {
      const bool isSmaller = around == nullptr || solid.front()->volume < around->front()->volume;
      if (surface.volume <= 0.0 && isSmaller && Holds(solid.front()->box, surface.box))
      {
        around = &solid;
      }
    }
    if (around != nullptr)
    {
      around->push_back(&surface);
    }
  }
  std::vector<CellSolid> solids;
  for (const std::vector<const Surface *> & bounds : ofSolid)
  {
    CellSolid solid;
    solid.cell = cell;
    for (const Surface * surface : bounds)
    {
      solid.surfaces.push_back(surface->walls);
      solid.volume += surface->volume;
    }
    solid.inside = FindInside(mesh, bounds);
    solids.push_back(std::move(solid));
  }
  return solids;
}
} // namespace

CellSolids
FindCellSolids(const WallMesh & mesh, std::size_t numberOfVertices)
{
  const std::vector<std::vector<Side>> sides = CollectSides(mesh, numberOfVertices);
  CellSolids                           result;
  const auto                           add = [&](std::size_t vertex) {
    const auto             surfaces = TakeApart(mesh, sides[vertex]);
    std::vector<CellSolid> solids = MakeSolids(mesh, static_cast<VertexId>(vertex), surfaces);
    std::move(solids.begin(), solids.end(), std::back_inserter(result.solids));
  };
  for (std::size_t vertex = ExteriorVertex + 1; vertex < numberOfVertices; ++vertex)
  {
    if (AreClosed(sides[vertex]))
    {
      add(vertex);
    }
    else
    {
      result.openCells.push_back(static_cast<VertexId>(vertex));
    }
  }
  if (AreClosed(sides[ExteriorVertex]))
  {
    add(ExteriorVertex);
  }
  return result;
}
} // namespace tissue
