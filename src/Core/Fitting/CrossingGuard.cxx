/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Fitting/CrossingGuard.h"

#include "TissueTessellationCore/Geometry/Box.h"
#include "TissueTessellationCore/Geometry/TriangleCrossing.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
using Triangle = std::array<PointId, 3>;

int
CountShared(const Triangle & a, const Triangle & b)
{
  int shared = 0;
  for (const PointId p : a)
  {
    shared += std::find(b.begin(), b.end(), p) != b.end() ? 1 : 0;
  }
  return shared;
}

/** Whether two triangles that share an edge lie nearly on each other, within 5 degrees. */
bool
IsFolded(const std::vector<Point> & points, const Triangle & a, const Triangle & b)
{
  constexpr double least = 0.996;
  PointId          ends[2] = { -1, -1 };
  PointId          apexA = -1;
  PointId          apexB = -1;
  int              n = 0;
  for (const PointId p : a)
  {
    if (std::find(b.begin(), b.end(), p) == b.end())
    {
      apexA = p;
    }
    else if (n < 2)
    {
      ends[n++] = p;
    }
  }
  for (const PointId p : b)
  {
    apexB = p != ends[0] && p != ends[1] ? p : apexB;
  }
  if (n < 2 || apexA < 0 || apexB < 0)
  {
    return false;
  }
  const Point axis = Normalized(points[ends[1]] - points[ends[0]]);
  const auto  across = [&](PointId apex) {
    const Point v = points[apex] - points[ends[0]];
    return Normalized(v - Dot(v, axis) * axis);
  };
  return Dot(across(apexA), across(apexB)) > least;
}

bool
IsFaulty(const std::vector<Point> & points, const Triangle & a, const Triangle & b)
{
  return CountShared(a, b) > 1 ? IsFolded(points, a, b) : TrianglesCross(points, a, b);
}

/** The given items for which the test holds, in their order. */
template <typename TTest>
std::vector<std::size_t>
Select(std::size_t count, const TTest & test, const ParallelFor & parallelFor)
{
  constexpr std::size_t                 chunk = 4096;
  std::vector<std::vector<std::size_t>> found((count + chunk - 1) / chunk);
  RunFor(parallelFor, found.size(), [&](std::size_t c) {
    for (std::size_t i = c * chunk; i < std::min(count, (c + 1) * chunk); ++i)
    {
      if (test(i))
      {
        found[c].push_back(i);
      }
    }
  });
  std::vector<std::size_t> all;
  for (const auto & part : found)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/** Pairs of triangles whose boxes, about their points here and there, overlap, and of which one is marked. */
std::vector<TrianglePair>
CollectClosePairs(const WallMesh & mesh, const std::vector<Point> & here, const std::vector<Point> & there,
                  const std::vector<unsigned char> & isMarked, const ParallelFor & parallelFor)
{
  if (mesh.triangles.empty())
  {
    return {};
  }
  std::vector<Box> boxes(mesh.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t)
  {
    const Triangle & triangle = mesh.triangles[t];
    boxes[t] = BoxOfTriangle(here, triangle);
    for (const PointId p : triangle)
    {
      Extend(boxes[t], there[p]);
    }
  }
  const BoxGrid                          grid(boxes);
  std::vector<std::vector<TrianglePair>> found(grid.NumberOfLayers());
  RunFor(parallelFor, found.size(), [&](std::size_t layer) {
    grid.VisitPairs(static_cast<std::int64_t>(layer), [&](std::int32_t a, std::int32_t b) {
      if (isMarked[a] != 0 || isMarked[b] != 0)
      {
        found[layer].push_back({ { a, b } });
      }
    });
  });
  std::vector<TrianglePair> pairs;
  for (const auto & part : found)
  {
    pairs.insert(pairs.end(), part.begin(), part.end());
  }
  return pairs;
}

/** Marks the triangles that have a point at two places. */
std::vector<unsigned char>
MarkMoved(const WallMesh & mesh, const std::vector<Point> & here, const std::vector<Point> & there)
{
  std::vector<unsigned char> isMoved(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < isMoved.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      isMoved[t] |= here[p] != there[p] ? 1 : 0;
    }
  }
  return isMoved;
}

std::vector<TrianglePair>
FindCrossingsOfMarked(const WallMesh & mesh, const std::vector<unsigned char> & isMarked,
                      const ParallelFor & parallelFor)
{
  const auto                close = CollectClosePairs(mesh, mesh.points, mesh.points, isMarked, parallelFor);
  std::vector<TrianglePair> crossings;
  const auto                test = [&](std::size_t i) {
    return TrianglesCross(mesh.points, mesh.triangles[close[i][0]], mesh.triangles[close[i][1]]);
  };
  for (const std::size_t i : Select(close.size(), test, parallelFor))
  {
    crossings.push_back(close[i]);
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

/** Marks the given walls and those whose boxes overlap theirs; at least one wall. */
std::vector<unsigned char>
MarkNearWalls(const WallMesh & mesh, const std::vector<unsigned char> & isGiven)
{
  std::vector<Box>           boxes(mesh.walls.size());
  std::vector<unsigned char> hasBox(mesh.walls.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const WallId wall = mesh.wallOfTriangle[t];
    const Box    box = BoxOfTriangle(mesh.points, mesh.triangles[t]);
    if (hasBox[wall] == 0)
    {
      hasBox[wall] = 1;
      boxes[wall] = box;
    }
    Extend(boxes[wall], box.lower);
    Extend(boxes[wall], box.upper);
  }
  std::vector<unsigned char> isNear = isGiven;
  const BoxGrid              grid(boxes);
  for (std::int64_t layer = 0; layer < grid.NumberOfLayers(); ++layer)
  {
    grid.VisitPairs(layer, [&](std::int32_t a, std::int32_t b) {
      isNear[a] |= isGiven[b];
      isNear[b] |= isGiven[a];
    });
  }
  return isNear;
}
} // namespace

std::vector<TrianglePair>
FindCrossings(const WallMesh & mesh, const ParallelFor & parallelFor)
{
  return FindCrossingsOfMarked(mesh, std::vector<unsigned char>(mesh.triangles.size(), 1), parallelFor);
}

std::vector<TrianglePair>
FindCrossingsOfWalls(const WallMesh & mesh, const std::vector<WallId> & walls, const ParallelFor & parallelFor)
{
  if (walls.empty())
  {
    return {};
  }
  std::vector<unsigned char> isOf(mesh.walls.size(), 0);
  for (const WallId wall : walls)
  {
    isOf[wall] = 1;
  }
  // They are few: of all other triangles only those of walls that are near them count.
  const std::vector<unsigned char> isNear = MarkNearWalls(mesh, isOf);
  WallMesh                         near;
  std::vector<unsigned char>       isMarked;
  std::vector<std::int32_t>        numbers;
  near.points = mesh.points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (isNear[mesh.wallOfTriangle[t]] != 0)
    {
      near.triangles.push_back(mesh.triangles[t]);
      isMarked.push_back(isOf[mesh.wallOfTriangle[t]]);
      numbers.push_back(static_cast<std::int32_t>(t));
    }
  }
  std::vector<TrianglePair> crossings = FindCrossingsOfMarked(near, isMarked, parallelFor);
  for (TrianglePair & pair : crossings)
  {
    pair = { { numbers[pair[0]], numbers[pair[1]] } };
  }
  return crossings;
}

std::int64_t
StepBackFromCrossings(WallMesh & mesh, const std::vector<Point> & before, const std::vector<double> & shares,
                      const ParallelFor & parallelFor)
{
  const std::vector<Point>        target = mesh.points;
  const std::vector<TrianglePair> pairs =
    CollectClosePairs(mesh, before, target, MarkMoved(mesh, before, target), parallelFor);
  // The number of steps back that each point took.
  std::vector<std::size_t>   level(mesh.points.size(), 0);
  std::vector<unsigned char> isChanged(mesh.triangles.size(), 1);
  std::vector<unsigned char> pointChanged(mesh.points.size(), 0);
  while (true)
  {
    const auto isFault = [&](std::size_t i) {
      const auto & [a, b] = pairs[i];
      return (isChanged[a] != 0 || isChanged[b] != 0) && IsFaulty(mesh.points, mesh.triangles[a], mesh.triangles[b]);
    };
    std::fill(pointChanged.begin(), pointChanged.end(), 0);
    bool isAny = false;
    for (const std::size_t i : Select(pairs.size(), isFault, parallelFor))
    {
      for (const std::int32_t t : pairs[i])
      {
        for (const PointId p : mesh.triangles[t])
        {
          if (pointChanged[p] == 0 && level[p] < shares.size() && target[p] != before[p])
          {
            pointChanged[p] = 1;
            const double share = shares[level[p]++];
            mesh.points[p] = share > 0.0 ? before[p] + share * (target[p] - before[p]) : before[p];
            isAny = true;
          }
        }
      }
    }
    if (!isAny)
    {
      break;
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      const Triangle & triangle = mesh.triangles[t];
      isChanged[t] = pointChanged[triangle[0]] | pointChanged[triangle[1]] | pointChanged[triangle[2]];
    }
  }
  return std::count_if(level.begin(), level.end(), [](std::size_t l) { return l > 0; });
}
} // namespace tissue
