/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/HeightField.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
using Edge = std::array<PointId, 2>;

/** The least cosine of the angle between a triangle's normal and the direction from which it is seen. Two triangles
 * within this angle of it, 78 degrees, are at least 23 degrees apart at their edge. */
constexpr double LeastCosine = 0.2;
/** The least height of a triangle over its longest edge: the normal of a flatter one may be rounded beyond use. */
constexpr double LeastHeight = 1e-6;
/** What a product of two lengths in the outline exceeds by far more than its rounding, over the largest of these. */
constexpr double LeastProduct = 1e-9;

Point
NormalOf(const WallMesh & mesh, const Triangle & t)
{
  return Cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
}

bool
Faces(const WallMesh & mesh, const Triangle & t, const Point & direction)
{
  double longest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const Point edge = mesh.points[t[i]] - mesh.points[t[i < 2 ? i + 1 : 0]];
    longest = std::max(longest, Dot(edge, edge));
  }
  const Point  normal = NormalOf(mesh, t);
  const double length = Norm(normal);
  return length > LeastHeight * longest && Dot(normal, direction) > LeastCosine * length;
}

/** The edges that the triangles have on one side only, in ascending order. */
std::vector<Edge>
CollectOutline(const WallMesh & mesh, std::size_t first, std::size_t end)
{
  std::vector<Edge> edges;
  const auto        isWithin = [&](PointId p) {
    return !mesh.numberOfCells.empty() && mesh.numberOfCells[p] == CellsWithinWall;
  };
  for (std::size_t t = first; t < end; ++t)
  {
    const Triangle & triangle = mesh.triangles[t];
    for (int i = 0; i < 3; ++i)
    {
      const Edge edge{ { triangle[i], triangle[i < 2 ? i + 1 : 0] } };
      if (!isWithin(edge[0]) && !isWithin(edge[1]))
      {
        edges.push_back(edge);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> outline;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(outline), [&](const Edge & edge) {
    return !std::binary_search(edges.begin(), edges.end(), Edge{ { edge[1], edge[0] } });
  });
  return outline;
}

/** The points of the outline one after the other; none where it is not one closed line that meets itself nowhere. */
std::vector<PointId>
OrderOutline(const std::vector<Edge> & outline)
{
  std::vector<PointId> order;
  const Edge *         edge = outline.data();
  while (order.size() < outline.size())
  {
    order.push_back((*edge)[0]);
    const auto next = std::lower_bound(outline.begin(), outline.end(), Edge{ { (*edge)[1], -1 } });
    if (next == outline.end() || (*next)[0] != (*edge)[1] || (next + 1 != outline.end() && next[1][0] == (*next)[0]))
    {
      return {};
    }
    edge = &*next;
    if (edge == outline.data())
    {
      break;
    }
  }
  return order.size() == outline.size() ? order : std::vector<PointId>();
}

/** Whether the outline, seen from a direction of length 1, winds once about the mean of its points, on and on to the
 * left. */
bool
IsStar(const WallMesh & mesh, const std::vector<PointId> & outline, const Point & direction)
{
  Point center{ { 0.0, 0.0, 0.0 } };
  for (const PointId p : outline)
  {
    center = center + (1.0 / static_cast<double>(outline.size())) * mesh.points[p];
  }
  const auto * least =
    std::min_element(direction.begin(), direction.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  Point axis{ { 0.0, 0.0, 0.0 } };
  axis[static_cast<std::size_t>(least - direction.begin())] = 1.0;
  const Point                        u = Normalized(Cross(axis, direction));
  const Point                        v = Cross(direction, u);
  std::vector<std::array<double, 2>> seen;
  double                             largest = 0.0;
  for (const PointId p : outline)
  {
    const Point way = mesh.points[p] - center;
    seen.push_back({ { Dot(way, u), Dot(way, v) } });
    largest = std::max(largest, Dot(way, way));
  }
  int turns = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    const auto & a = seen[i];
    const auto & b = seen[i + 1 < seen.size() ? i + 1 : 0];
    if (!(a[0] * b[1] - a[1] * b[0] > LeastProduct * largest))
    {
      return false;
    }
    turns += a[1] < 0.0 && b[1] >= 0.0 ? 1 : 0;
  }
  return turns == 1;
}
} // namespace

bool
IsHeightField(const WallMesh & mesh, std::size_t first, std::size_t end)
{
  Point sum{ { 0.0, 0.0, 0.0 } };
  for (std::size_t t = first; t < end; ++t)
  {
    sum = sum + NormalOf(mesh, mesh.triangles[t]);
  }
  const double length = Norm(sum);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return false;
  }
  const Point direction = (1.0 / length) * sum;
  const auto  begin = mesh.triangles.begin();
  if (!std::all_of(begin + static_cast<std::ptrdiff_t>(first),
                   begin + static_cast<std::ptrdiff_t>(end),
                   [&](const Triangle & t) { return Faces(mesh, t, direction); }))
  {
    return false;
  }
  const std::vector<PointId> outline = OrderOutline(CollectOutline(mesh, first, end));
  return !outline.empty() && IsStar(mesh, outline, direction);
}

std::vector<unsigned char>
MarkHeightFields(const WallMesh & mesh, const std::vector<std::size_t> & firstOfRuns,
                 const std::vector<unsigned char> & isWanted, const Execution & execution)
{
  constexpr std::size_t      chunk = 64; // runs enough to outweigh the call
  const std::size_t          numberOfRuns = firstOfRuns.size() - 1;
  std::vector<unsigned char> isHeightField(numberOfRuns, 0);
  execution.For((numberOfRuns + chunk - 1) / chunk, [&](std::size_t c) {
    for (std::size_t run = c * chunk; run < std::min(numberOfRuns, (c + 1) * chunk); ++run)
    {
      isHeightField[run] = isWanted[run] != 0 && IsHeightField(mesh, firstOfRuns[run], firstOfRuns[run + 1]) ? 1 : 0;
    }
  });
  return isHeightField;
}
} // namespace tissue
