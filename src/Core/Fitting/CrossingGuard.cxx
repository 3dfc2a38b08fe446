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
#include "Mesh/HeightField.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
/** The limits as the tests have them. */
struct Limits
{
  double largestFold; // the cosine of the least angle between two triangles at an edge
  double leastSine;   // of the least angle in a triangle
};

double
SineOfLeastAngle(const Point & a, const Point & b, const Point & c)
{
  const double ab = Dot(b - a, b - a);
  const double bc = Dot(c - b, c - b);
  const double ca = Dot(a - c, a - c);
  // The least angle is opposite to the shortest edge.
  const double product = ab * bc * ca / std::min({ ab, bc, ca });
  return product > 0.0 ? Norm(Cross(b - a, c - a)) / std::sqrt(product) : 0.0;
}

int
CountShared(const Triangle & a, const Triangle & b)
{
  int shared = 0;
  for (const PointId p : a)
  {
    shared += static_cast<int>(p == b[0]) | static_cast<int>(p == b[1]) | static_cast<int>(p == b[2]);
  }
  return shared;
}

/** The cosine of the angle at their edge between two triangles that share one; -1 where they share none. */
double
FoldOf(const std::vector<Point> & points, const Triangle & a, const Triangle & b)
{
  PointId ends[2] = { -1, -1 };
  PointId apexA = -1;
  PointId apexB = -1;
  int     n = 0;
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
    return -1.0;
  }
  const Point axis = Normalized(points[ends[1]] - points[ends[0]]);
  const auto  across = [&](PointId apex) {
    const Point v = points[apex] - points[ends[0]];
    return Normalized(v - Dot(v, axis) * axis);
  };
  return Dot(across(apexA), across(apexB));
}

/** Tells whether two triangles cross, or, where they share an edge and so cannot, are folded onto each other, and more
 * so than before. */
bool
IsFaulty(const std::vector<Point> & points, const std::vector<Point> & before, const Triangle & a, const Triangle & b,
         const Limits & limits)
{
  if (CountShared(a, b) < 2)
  {
    return TrianglesCross(points, a, b);
  }
  const double fold = FoldOf(points, a, b);
  return fold > limits.largestFold && fold > FoldOf(before, a, b);
}

/** Tells whether a triangle has a small angle, and a smaller one than before. */
bool
IsSliver(const std::vector<Point> & points, const std::vector<Point> & before, const Triangle & t,
         const Limits & limits)
{
  const double sine = SineOfLeastAngle(points[t[0]], points[t[1]], points[t[2]]);
  return sine < limits.leastSine && sine < SineOfLeastAngle(before[t[0]], before[t[1]], before[t[2]]);
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
                      const AngleLimits & angles, const Execution & execution)
{
  constexpr double radiansPerDegree = 0.017453292519943295;
  const Limits     limits{ std::cos(radiansPerDegree * angles.dihedralAngle),
                       std::sin(radiansPerDegree * angles.triangleAngle) };
  // In each round the movable points of the faulty pairs step back; then only pairs of changed triangles are tested.
  const std::vector<Point>   target = mesh.points;
  std::vector<unsigned char> isChanged = MarkMoved(mesh, before, target);
  // The level of a point is the number of steps back that it took.
  std::vector<std::size_t>   level(mesh.points.size(), 0);
  std::vector<unsigned char> pointChanged(mesh.points.size(), 0);
  const bool                 mayMeetWithin = angles.dihedralAngle > LeastFoldOfHeightField;
  while (true)
  {
    const auto isFaulty = [&](const TrianglePair & pair) {
      return IsFaulty(mesh.points, before, mesh.triangles[pair[0]], mesh.triangles[pair[1]], limits);
    };
    const auto isSliver = [&](std::size_t t) {
      return isChanged[t] != 0 && IsSliver(mesh.points, before, mesh.triangles[t], limits);
    };
    std::fill(pointChanged.begin(), pointChanged.end(), 0);
    bool       isAny = false;
    const auto stepBack = [&](std::size_t t) {
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
    };
    const std::vector<std::size_t> slivers = Select(mesh.triangles.size(), isSliver, execution);
    for (const auto & [a, b] : SelectClosePairs(mesh, isChanged, mayMeetWithin, isFaulty, execution))
    {
      stepBack(static_cast<std::size_t>(a));
      stepBack(static_cast<std::size_t>(b));
    }
    std::for_each(slivers.begin(), slivers.end(), stepBack);
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
