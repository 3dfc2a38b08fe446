/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/TriangleCrossing.h"

#include "TissueTessellationCore/ExactPredicates.h"
#include "TissueTessellationCore/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
using Triangle = std::array<PointId, 3>;

/** Orientation(), by floating-point numbers where their rounding cannot change the sign
 * (J. R. Shewchuk, Adaptive precision floating-point arithmetic, 1997, doi:10.1007/PL00009321). */
int
FilteredOrientation(const Point & a, const Point & b, const Point & c, const Point & d)
{
  constexpr double bound = 1e-15;
  const Point      u = a - d;
  const Point      v = b - d;
  const Point      w = c - d;
  const double     vw[3] = { v[1] * w[2], v[2] * w[0], v[0] * w[1] };
  const double     wv[3] = { v[2] * w[1], v[0] * w[2], v[1] * w[0] };
  double           determinant = 0.0;
  double           permanent = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    determinant += u[i] * (vw[i] - wv[i]);
    permanent += std::abs(u[i]) * (std::abs(vw[i]) + std::abs(wv[i]));
  }
  if (std::abs(determinant) > bound * permanent)
  {
    return determinant > 0.0 ? -1 : 1;
  }
  return Orientation(a, b, c, d);
}

bool
SegmentMeetsTriangle(const Point & p, const Point & q, const Point & a, const Point & b, const Point & c)
{
  const int sides[3] = { FilteredOrientation(p, q, a, b),
                         FilteredOrientation(p, q, b, c),
                         FilteredOrientation(p, q, c, a) };
  const auto [least, most] = std::minmax_element(sides, sides + 3);
  return *least >= 0 || *most <= 0;
}

/** Whether triangles in one plane overlap: no edge of either has the other on its outer side. */
bool
CoplanarTrianglesOverlap(const std::array<Point, 3> & a, const std::array<Point, 3> & b)
{
  const Point normal = Normalized(Cross(a[1] - a[0], a[2] - a[0]));
  const auto  isSeparatedBy = [&normal](const std::array<Point, 3> & s, const std::array<Point, 3> & t) {
    for (int i = 0; i < 3; ++i)
    {
      Point        outward = Normalized(Cross(s[(i + 1) % 3] - s[i], normal));
      const double inside = Dot(s[(i + 2) % 3] - s[i], outward);
      outward = inside > 0.0 ? -1.0 * outward : outward;
      const double tolerance = 1e-9 * Distance(s[i], s[(i + 1) % 3]);
      if (std::all_of(t.begin(), t.end(), [&](const Point & p) { return Dot(p - s[i], outward) >= -tolerance; }))
      {
        return true;
      }
    }
    return false;
  };
  return !isSeparatedBy(a, b) && !isSeparatedBy(b, a);
}

/** The triangle turned so that the point comes first. */
Triangle
TurnedTo(const Triangle & t, PointId first)
{
  const auto i = std::find(t.begin(), t.end(), first) - t.begin();
  return { { t[i], t[(i + 1) % 3], t[(i + 2) % 3] } };
}
} // namespace

bool
TrianglesCross(const std::vector<Point> & points, const Triangle & first, const Triangle & second)
{
  PointId shared = -1;
  int     numberShared = 0;
  for (const PointId p : first)
  {
    if (std::find(second.begin(), second.end(), p) != second.end())
    {
      shared = p;
      ++numberShared;
    }
  }
  if (numberShared > 1)
  {
    return false;
  }
  const Triangle s = numberShared == 1 ? TurnedTo(first, shared) : first;
  const Triangle t = numberShared == 1 ? TurnedTo(second, shared) : second;

  const std::array<Point, 3> a{ { points[s[0]], points[s[1]], points[s[2]] } };
  const std::array<Point, 3> b{ { points[t[0]], points[t[1]], points[t[2]] } };
  int                        sideOfA[3];
  int                        sideOfB[3];
  const auto                 misses =
    [numberShared](const std::array<Point, 3> & plane, const std::array<Point, 3> & other, int * side) {
      for (int i = 0; i < 3; ++i)
      {
        side[i] = i == 0 && numberShared == 1 ? 0 : FilteredOrientation(plane[0], plane[1], plane[2], other[i]);
      }
      const int begin = numberShared;
      return (*std::min_element(side + begin, side + 3) > 0) || (*std::max_element(side + begin, side + 3) < 0);
    };
  if (misses(a, b, sideOfB) || misses(b, a, sideOfA))
  {
    return false;
  }
  if (std::all_of(sideOfB, sideOfB + 3, [](int side) { return side == 0; }))
  {
    return CoplanarTrianglesOverlap(a, b);
  }
  const auto edgeMeets =
    [numberShared](const std::array<Point, 3> & edges, const int * side, const std::array<Point, 3> & other) {
      for (int i = 0; i < 3; ++i)
      {
        const int j = (i + 1) % 3;
        // Edges at a shared point meet the other triangle there, and elsewhere only where the opposite edge does.
        const bool isAtShared = numberShared == 1 && i != 1;
        if (!isAtShared && side[i] * side[j] <= 0 && (side[i] != 0 || side[j] != 0) &&
            SegmentMeetsTriangle(edges[i], edges[j], other[0], other[1], other[2]))
        {
          return true;
        }
      }
      return false;
    };
  return edgeMeets(a, sideOfA, b) || edgeMeets(b, sideOfB, a);
}
} // namespace tissue
