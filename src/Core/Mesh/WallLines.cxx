/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallLines.h"

#include "Common/Algorithms.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <tuple>

namespace tissue
{
namespace
{
/** A line's edge, once in each direction. */
struct LineEdge
{
  PointId                                    from;
  PointId                                    to;
  boost::container::static_vector<WallId, 3> walls;
};

/** Sorted by `from`, then by `to`. */
std::vector<LineEdge>
CollectLineEdges(const WallMesh & mesh)
{
  using Side = std::array<std::int32_t, 3>; // the points ascending, the wall
  std::vector<Side> sides;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const PointId a = mesh.triangles[t][i];
      const PointId b = mesh.triangles[t][(i + 1) % 3];
      if (mesh.numberOfCells[a] >= CellsOnLine && mesh.numberOfCells[b] >= CellsOnLine)
      {
        sides.push_back({ { std::min(a, b), std::max(a, b), mesh.wallOfTriangle[t] } });
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<LineEdge> edges;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    LineEdge edge{ sides[begin][0], sides[begin][1], {} };
    for (; end < sides.size() && sides[end][0] == edge.from && sides[end][1] == edge.to; ++end)
    {
      if (edge.walls.size() < edge.walls.capacity())
      {
        edge.walls.push_back(sides[end][2]);
      }
    }
    // An edge from one side of a wall's outline to another is in two triangles, both of that wall.
    if (edge.walls.size() > 1 && edge.walls.front() != edge.walls.back())
    {
      edges.push_back(edge);
      std::swap(edge.from, edge.to);
      edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end(), [](const LineEdge & a, const LineEdge & b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  return edges;
}
} // namespace

std::vector<WallLine>
CollectWallLines(const WallMesh & mesh)
{
  const std::vector<LineEdge> edges = CollectLineEdges(mesh);
  // The next edge along the line; the end of the line has more than one to follow, or none.
  const auto follow = [&edges](const LineEdge & edge) {
    auto next = std::lower_bound(
      edges.begin(), edges.end(), edge.to, [](const LineEdge & e, PointId point) { return e.from < point; });
    return next->to == edge.from ? next + 1 : next;
  };
  std::vector<WallLine> lines;
  for (const LineEdge & first : edges)
  {
    if (mesh.numberOfCells[first.from] < CellsAtCorner)
    {
      continue;
    }
    WallLine line;
    line.walls = first.walls;
    line.points = { first.from, first.to };
    for (const LineEdge * edge = &first; mesh.numberOfCells[edge->to] == CellsOnLine;)
    {
      edge = &*follow(*edge);
      line.points.push_back(edge->to);
    }
    if (line.points.front() < line.points.back())
    {
      lines.push_back(std::move(line));
    }
  }
  std::sort(lines.begin(), lines.end(), [](const WallLine & a, const WallLine & b) {
    return std::make_tuple(a.points.front(), a.points.back(), a.walls) <
           std::make_tuple(b.points.front(), b.points.back(), b.walls);
  });
  return lines;
}

std::vector<bool>
FindDoubledLines(const std::vector<WallLine> & lines)
{
  const auto haveSameEnds = [&lines](std::size_t i, std::size_t j) {
    return lines[i].points.front() == lines[j].points.front() && lines[i].points.back() == lines[j].points.back();
  };
  std::vector<bool> isDoubled(lines.size(), false);
  for (std::size_t i = 1; i < lines.size(); ++i)
  {
    if (haveSameEnds(i - 1, i))
    {
      isDoubled[i - 1] = true;
      isDoubled[i] = true;
    }
  }
  return isDoubled;
}

double
LengthOf(const WallLine & line, const std::vector<Point> & points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i)
  {
    length += Distance(points[line.points[i - 1]], points[line.points[i]]);
  }
  return length;
}

WallsAtPoints::WallsAtPoints(const WallMesh & mesh)
{
  std::vector<std::array<std::int32_t, 2>> incidences;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      if (mesh.numberOfCells[p] >= CellsOnLine)
      {
        incidences.push_back({ { p, mesh.wallOfTriangle[t] } });
      }
    }
  }
  SortUnique(incidences);
  m_Walls.Assign(mesh.points.size(), [&incidences](const auto & add) {
    for (const auto & [point, wall] : incidences)
    {
      add(point, wall);
    }
  });
}

int
WallsAtPoints::CountCommon(PointId a, PointId b) const
{
  int        count = 0;
  const auto wallsOfA = m_Walls[a];
  const auto wallsOfB = m_Walls[b];
  auto       i = wallsOfA.begin();
  auto       k = wallsOfB.begin();
  while (i != wallsOfA.end() && k != wallsOfB.end())
  {
    count += *i == *k ? 1 : 0;
    const bool advance = *i <= *k;
    k += *k <= *i ? 1 : 0;
    i += advance ? 1 : 0;
  }
  return count;
}
} // namespace tissue
