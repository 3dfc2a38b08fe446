/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/TriangleCrossing.h"

#include "Geometry/ExactPredicates.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** Returns Orientation(), by floating-point numbers where their rounding cannot change the sign (J. R. Shewchuk,
 * Adaptive precision floating-point arithmetic, 1997, doi:10.1007/PL00009321). */
int
FilteredOrientation(const Point & a, const Point & b, const Point & c, const Point & d)
{
  // The determinant's error is at most (7 + 56 e) e of the permanent (Shewchuk), 7.8e-16 with e = 2^-53; rounded up.
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

/** Returns the triangle's points, turned so that the one at this position comes first. */
std::array<Point, 3>
TurnedTo(const std::vector<Point> & points, const Triangle & t, int position)
{
  constexpr int next[3] = { 1, 2, 0 };
  const int     second = next[position];
  return { { points[t[position]], points[t[second]], points[t[next[second]]] } };
}

/** \brief The plane of a triangle, which tells the side of many points faster than Orientation() does. */
class Plane
{
public:
  explicit Plane(const std::array<Point, 3> & triangle)
    : m_Triangle(triangle)
  {
    const Point u = triangle[1] - triangle[0];
    const Point v = triangle[2] - triangle[0];
    m_Normal = Cross(u, v);
    m_Bound = MostOf(u) * MostOf(v);
  }

  /** Orientation() of the triangle and the point. */
  int
  SideOf(const Point & p) const
  {
    // With e = 2^-53 a coordinate of the normal is off by at most 8 e times the product of the largest coordinates of
    // the two edges, and the product by at most 34 e times all three largest: 3.8e-15, rounded up.
    constexpr double bound = 1e-14;
    const Point      w = p - m_Triangle[0];
    const double     product = Dot(m_Normal, w);
    if (std::abs(product) > bound * m_Bound * MostOf(w))
    {
      return product > 0.0 ? 1 : -1;
    }
    return Orientation(m_Triangle[0], m_Triangle[1], m_Triangle[2], p);
  }

private:
  static double
  MostOf(const Point & v)
  {
    return std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
  }

  const std::array<Point, 3> & m_Triangle;
  Point                        m_Normal;
  double                       m_Bound = 0.0;
};

/** Whether all points of a triangle, from the given one on, are on the same side of the plane of another. */
bool
IsBeside(const std::array<Point, 3> & triangle, int from, const std::array<Point, 3> & other)
{
  const Plane plane(other);
  const int   side = plane.SideOf(triangle[from]);
  for (int i = from + 1; side != 0 && i < 3; ++i)
  {
    if (plane.SideOf(triangle[i]) != side)
    {
      return false;
    }
  }
  return side != 0;
}

/** Whether the line through the i-th edge of a triangle passes the other one by. Where it does not, the edge may meet
 * the other triangle or not. */
bool
EdgePasses(const std::array<Point, 3> & edges, int i, const std::array<Point, 3> & other)
{
  const Point & p = edges[i];
  const Point & q = edges[i < 2 ? i + 1 : 0];
  const int     first = FilteredOrientation(p, q, other[0], other[1]);
  const int     second = FilteredOrientation(p, q, other[1], other[2]);
  return first * second < 0 ||
         (first + second != 0 && (first + second > 0 ? 1 : -1) == -FilteredOrientation(p, q, other[2], other[0]));
}

/** Whether the edge opposite to a triangle's first point, which is the other's first as well, meets the other one. */
bool
OppositeEdgeMeets(const std::array<Point, 3> & t, const std::array<Point, 3> & other)
{
  const std::array<Point, 3> edge{ { t[1], t[2], t[2] } };
  if (EdgePasses(t, 1, other) || !TrianglesMeet(edge, other))
  {
    return false;
  }
  // Where the triangle is flat, the shared point can be on that edge. Then another point must be common.
  const auto isCommon = [&](const Point & p) { return p != t[0] && TrianglesMeet({ { p, p, p } }, other); };
  return !TrianglesMeet(edge, { { t[0], t[0], t[0] } }) || isCommon(t[1]) || isCommon(t[2]);
}

/** Whether triangles without a shared point meet. They do not where the lines through all six edges pass the other
 * triangle by. Where one does not, the exact test decides. */
bool
SeparateTrianglesMeet(const std::array<Point, 3> & s, const std::array<Point, 3> & t)
{
  for (int i = 0; i < 3; ++i)
  {
    if (!EdgePasses(s, i, t) || !EdgePasses(t, i, s))
    {
      return TrianglesMeet(s, t);
    }
  }
  return false;
}

/** Whether two triangles that share the edge (a, b) lie on each other; c and d are the points opposite to it. */
bool
AreFolded(const Point & a, const Point & b, const Point & c, const Point & d)
{
  // Most triangles are far from it: the product of their normals is below 0 by more than its rounding. The bound is 90
  // times the rounding of one operation, 1.1e-16, which is well above what the product's operations add up to.
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
  // The points that both have, by their indices, decide what is asked: of three the triangles are the same, of two they
  // cross if they are folded. With one or none, the other points of one are most often on one side of the other's
  // plane; if not, the edges are looked at.
  PointId shared[3] = { -1, -1, -1 };
  int     numberShared = 0;
  int     inFirst = 0;
  int     inSecond = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (first[i] == second[j] && first[i] != shared[0] && first[i] != shared[1])
      {
        shared[numberShared++] = first[i];
        inFirst = i;
        inSecond = j;
      }
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
      return points[at != t.end() ? *at : shared[0]]; // A triangle may have a point twice.
    };
    return AreFolded(points[shared[0]], points[shared[1]], apex(first), apex(second));
  }
  const auto s = TurnedTo(points, first, inFirst);
  const auto t = TurnedTo(points, second, inSecond);
  if (IsBeside(t, numberShared, s) || IsBeside(s, numberShared, t))
  {
    return false;
  }
  return numberShared == 1 ? OppositeEdgeMeets(s, t) || OppositeEdgeMeets(t, s) : SeparateTrianglesMeet(s, t);
}
} // namespace tissue
