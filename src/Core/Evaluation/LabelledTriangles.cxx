/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Evaluation/LabelledTriangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace tissue
{
namespace
{
using LabelledTriangle = LabelledTriangles::Triangle;

/** Turns the triangle so that its first cell has the smaller vertex, and the exterior is the second. */
LabelledTriangle
Orient(LabelledTriangle triangle)
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
RequirePoints(const std::array<PointId, 3> & points, std::size_t triangle, std::size_t numberOfPoints)
{
  for (const PointId p : points)
  {
    if (p < 0 || static_cast<std::size_t>(p) >= numberOfPoints)
    {
      throw std::invalid_argument("triangle " + std::to_string(triangle) + " has point " + std::to_string(p) +
                                  ", must be at least 0 and below " + std::to_string(numberOfPoints));
    }
  }
}

void
Check(const LabelledTriangles & mesh)
{
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const LabelledTriangle & triangle = mesh.triangles[t];
    if (triangle.cells[0] == triangle.cells[1])
    {
      throw std::invalid_argument("triangle " + std::to_string(t) + " has cell " + std::to_string(triangle.cells[0]) +
                                  " on both sides");
    }
    RequirePoints(triangle.points, t, mesh.points.size());
  }
}

/** Finds for each point the first one at the same place. */
std::vector<PointId>
FindFirstAtPlace(const std::vector<Point> & points)
{
  std::vector<PointId> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&points](PointId a, PointId b) {
    return points[a] != points[b] ? points[a] < points[b] : a < b;
  });
  std::vector<PointId> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isSame = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = isSame ? first[order[i - 1]] : order[i];
  }
  return first;
}

/** Where no cell has the label -1, it is the exterior's, as other programs write it. */
VertexId
VertexOfLabel(Label label, std::size_t triangle, const JunctionSet & junctions)
{
  constexpr Label outside = -1;
  const auto &    cells = junctions.cells;
  const auto      at = std::lower_bound(
    cells.begin() + 1, cells.end(), label, [](const Cell & cell, Label wanted) { return cell.label < wanted; });
  if (at != cells.end() && at->label == label)
  {
    return static_cast<VertexId>(at - cells.begin());
  }
  const std::vector<Label> & exterior = junctions.exteriorLabels;
  if (label != outside && label != cells[ExteriorVertex].label &&
      std::find(exterior.begin(), exterior.end(), label) == exterior.end())
  {
    throw std::invalid_argument("triangle " + std::to_string(triangle) + " has label " + std::to_string(label) +
                                ", which the image has not; the label of its exterior is " +
                                std::to_string(cells[ExteriorVertex].label));
  }
  return ExteriorVertex;
}
} // namespace

LabelledTriangles
FindCellsOfTriangles(const TrianglesOfLabels & mesh, const JunctionSet & junctions)
{
  LabelledTriangles result;
  result.points = mesh.points;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    const Point & point = mesh.points[p];
    if (!std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); }))
    {
      throw std::invalid_argument("point " + std::to_string(p) + " is not finite");
    }
  }
  const std::vector<PointId> first = FindFirstAtPlace(mesh.points);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & [points, labels] = mesh.triangles[t];
    RequirePoints(points, t, mesh.points.size());
    if (labels[0] == labels[1])
    {
      throw std::invalid_argument("triangle " + std::to_string(t) + " has label " + std::to_string(labels[0]) +
                                  " on both sides");
    }
    const VertexPair cells{ { VertexOfLabel(labels[0], t, junctions), VertexOfLabel(labels[1], t, junctions) } };
    if (cells[0] != cells[1])
    {
      result.triangles.push_back({ { { first[points[0]], first[points[1]], first[points[2]] } }, cells });
    }
  }
  return result;
}

WallMesh
MakeWallMesh(const LabelledTriangles & mesh)
{
  // Oriented triangles of a wall have the same pair of cells, so that sorting by it groups them. Points that are in use
  // are then numbered in their order, and walls begin where the pair changes.
  Check(mesh);
  std::vector<LabelledTriangle> triangles(mesh.triangles.size());
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), triangles.begin(), Orient);
  std::stable_sort(triangles.begin(), triangles.end(), [](const LabelledTriangle & a, const LabelledTriangle & b) {
    return a.cells < b.cells;
  });

  constexpr PointId    unused = -1;
  std::vector<PointId> newIds(mesh.points.size(), unused);
  for (const LabelledTriangle & triangle : triangles)
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
  for (const LabelledTriangle & triangle : triangles)
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
