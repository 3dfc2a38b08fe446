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

/** The triangle turned so that the point comes first. */
std::array<Point, 3>
TurnedTo(const std::vector<Point> & points, const Triangle & t, PointId point)
{
  const auto i = std::find(t.begin(), t.end(), point) - t.begin();
  return { { points[t[i % 3]], points[t[(i + 1) % 3]], points[t[(i + 2) % 3]] } };
}

/** Whether all points of a triangle from the given one on are on one side of the plane of another. */
bool
IsBeside(const std::array<Point, 3> & triangle, int from, const std::array<Point, 3> & plane)
{
  const int side = FilteredOrientation(plane[0], plane[1], plane[2], triangle[from]);
  for (int i = from + 1; side != 0 && i < 3; ++i)
  {
    if (FilteredOrientation(plane[0], plane[1], plane[2], triangle[i]) != side)
    {
      return false;
    }
  }
  return side != 0;
}

/** Whether the edge opposite to a triangle's first point, which both share, meets the other triangle. */
bool
OppositeEdgeMeets(const std::array<Point, 3> & t, const std::array<Point, 3> & other)
{
  const std::array<Point, 3> edge{ { t[1], t[2], t[2] } };
  if (!TrianglesMeet(edge, other))
  {
    return false;
  }
  // Where all is on one line the shared point can be on that edge.
  const auto isCommon = [&](const Point & p) { return p != t[0] && TrianglesMeet({ { p, p, p } }, other); };
  return !TrianglesMeet(edge, { { t[0], t[0], t[0] } }) || isCommon(t[1]) || isCommon(t[2]);
}

/** Whether triangles that share the edge (a, b) lie on each other, with c and d opposite to it. */
bool
AreFolded(const Point & a, const Point & b, const Point & c, const Point & d)
{
  // Most are far from it: the product of their normals, with more than its rounding, is negative.
  constexpr double bound = 1e-14;
  const Point      edge = b - a;
  const Point      u = c - a;
  const Point      v = d - a;
  const double     product = Dot(Cross(edge, u), Cross(edge, v));
  if (product < -bound * Dot(edge, edge) * Norm(u) * Norm(v))
  {
    return false;
  }
  return FilteredOrientation(a, b, c, d) == 0 && AreOnOneSide(a, b, c, d);
}
} // namespace

bool
TrianglesCross(const std::vector<Point> & points, const Triangle & first, const Triangle & second)
{
  Triangle shared{};
  int      numberShared = 0;
  for (const PointId p : first)
  {
    const bool isNew = std::find(shared.begin(), shared.begin() + numberShared, p) == shared.begin() + numberShared;
    if (isNew && std::find(second.begin(), second.end(), p) != second.end())
    {
      shared[numberShared++] = p;
    }
  }
  if (numberShared == 3)
  {
    return true;
  }
  if (numberShared == 2)
  {
    const auto apex = [&](const Triangle & t) {
      const auto at = std::find_if(t.begin(), t.end(), [&](PointId p) { return p != shared[0] && p != shared[1]; });
      return points[at != t.end() ? *at : shared[0]]; // a point may be there twice
    };
    return AreFolded(points[shared[0]], points[shared[1]], apex(first), apex(second));
  }
  const bool isAtPoint = numberShared == 1;
  const auto s = TurnedTo(points, first, isAtPoint ? shared[0] : first[0]);
  const auto t = TurnedTo(points, second, isAtPoint ? shared[0] : second[0]);
  if (IsBeside(t, numberShared, s) || IsBeside(s, numberShared, t))
  {
    return false;
  }
  return isAtPoint ? OppositeEdgeMeets(s, t) || OppositeEdgeMeets(t, s) : TrianglesMeet(s, t);
}
} // namespace tissue
