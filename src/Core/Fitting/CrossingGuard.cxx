/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CrossingGuard.h"

#include "Common/Algorithms.h"
#include "Geometry/TriangleCrossing.h"
#include "Mesh/Crossings.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
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

/** Tells whether two triangles that share an edge lie on each other to within 5 degrees.
 *
 * The angle is that between the directions from the edge, at right angles to it, to the two apexes. */
bool
IsFolded(const std::vector<Point> & points, const Triangle & a, const Triangle & b)
{
  constexpr double least = 0.996; // This is the cosine of 5 degrees.
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

/** Tells whether two triangles cross, or, where they share an edge and so cannot, are folded onto each other. */
bool
IsFaulty(const std::vector<Point> & points, const Triangle & a, const Triangle & b)
{
  return CountShared(a, b) > 1 ? IsFolded(points, a, b) : TrianglesCross(points, a, b);
}

/** Marks the triangles of which a point is at two different places. */
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

} // namespace

std::int64_t
StepBackFromCrossings(WallMesh & mesh, const std::vector<Point> & before, const std::vector<double> & shares,
                      const Execution & execution)
{
  // Only pairs whose boxes, about all places from before to target, overlap can become faulty: they are collected once.
  // In each round the movable points of the faulty pairs step back; then only pairs of changed triangles are tested.
  const std::vector<Point>        target = mesh.points;
  const std::vector<TrianglePair> pairs =
    CollectClosePairs(mesh, before, target, MarkMoved(mesh, before, target), execution);
  // The level of a point is the number of steps back that it took.
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
    for (const std::size_t i : Select(pairs.size(), isFault, execution))
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
