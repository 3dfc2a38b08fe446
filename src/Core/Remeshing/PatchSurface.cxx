/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/PatchSurface.h"

#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue
{
namespace
{
using Weights = std::array<double, 3>;

/** Returns the weights of the point of a triangle that is nearest to p (C. Ericson, Real-Time Collision Detection,
 * 5.1.5). The regions of space whose nearest point is a corner, or on an edge, are ruled out one after the other; what
 * is left is above the inside. The products d1 to d6 tell how far p is along the edges from each corner; va, vb and vc
 * are the barycentric weights of p, projected to the triangle's plane, times the squared normal. */
Weights
NearestInTriangle(const Point & p, const Point & a, const Point & b, const Point & c)
{
  const Point  ab = b - a;
  const Point  ac = c - a;
  const double d1 = Dot(ab, p - a);
  const double d2 = Dot(ac, p - a);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return { { 1.0, 0.0, 0.0 } };
  }
  const double d3 = Dot(ab, p - b);
  const double d4 = Dot(ac, p - b);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return { { 0.0, 1.0, 0.0 } };
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    const double v = d1 / (d1 - d3);
    return { { 1.0 - v, v, 0.0 } };
  }
  const double d5 = Dot(ab, p - c);
  const double d6 = Dot(ac, p - c);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return { { 0.0, 0.0, 1.0 } };
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    const double w = d2 / (d2 - d6);
    return { { 1.0 - w, 0.0, w } };
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return { { 0.0, 1.0 - w, w } };
  }
  const double sum = va + vb + vc;
  return { { va / sum, vb / sum, vc / sum } };
}

Point
Combine(const Weights & weights, const Point & a, const Point & b, const Point & c)
{
  return weights[0] * a + weights[1] * b + weights[2] * c;
}
} // namespace

PatchSurface::PatchSurface(const WallPatch & patch)
  : m_Patch(patch)
  , m_Normals(patch.EndOfVertices(), Point{ { 0.0, 0.0, 0.0 } })
{
  for (WallPatch::HalfEdge h = 0; h < m_Patch.EndOfHalfEdges(); h += 3)
  {
    const Point & a = m_Patch.PointAt(m_Patch.From(h));
    const Point & b = m_Patch.PointAt(m_Patch.To(h));
    const Point   normal = Cross(b - a, m_Patch.PointAt(m_Patch.Opposite(h)) - a);
    for (int i = 0; i < 3; ++i)
    {
      Point & sum = m_Normals[m_Patch.From(h + i)];
      sum = sum + normal;
    }
  }
  for (Point & normal : m_Normals)
  {
    normal = Normalized(normal);
  }
}

PatchSurface::Foot
PatchSurface::FootAt(WallPatch::Vertex v) const
{
  return { m_Patch.PointAt(v), m_Normals[v], m_Patch.Leaving(v) / 3 };
}

PatchSurface::Nearest
PatchSurface::FindNearest(std::int32_t triangle, const Point & point) const
{
  const Point & a = m_Patch.PointAt(m_Patch.From(3 * triangle));
  const Point & b = m_Patch.PointAt(m_Patch.From(3 * triangle + 1));
  const Point & c = m_Patch.PointAt(m_Patch.From(3 * triangle + 2));
  Nearest       nearest;
  nearest.weights = NearestInTriangle(point, a, b, c);
  nearest.point = Combine(nearest.weights, a, b, c);
  const Point away = point - nearest.point;
  nearest.squaredDistance = Dot(away, away);
  return nearest;
}

PatchSurface::Foot
PatchSurface::FindFoot(const Point & point, std::int32_t start) const
{
  // From a triangle whose nearest point is at a corner, the walk looks at all triangles at that corner; where it is on
  // an edge, at the one beyond the edge; inside, it ends. Each step must come nearer by more than rounding.
  std::int32_t triangle = start;
  Nearest      nearest = this->FindNearest(triangle, point);
  const auto   tryTriangle = [&](WallPatch::HalfEdge h) {
    if (h != WallPatch::None)
    {
      const Nearest other = this->FindNearest(h / 3, point);
      if (other.squaredDistance < nearest.squaredDistance * (1.0 - 1e-9))
      {
        nearest = other;
        triangle = h / 3;
        return true;
      }
    }
    return false;
  };
  for (bool moved = true; moved;)
  {
    moved = false;
    const std::int32_t at = triangle;
    const Weights      weights = nearest.weights;
    for (int i = 0; i < 3; ++i)
    {
      const WallPatch::HalfEdge edge = 3 * at + (i + 1) % 3; // The edge opposite to corner i.
      if (weights[i] == 1.0)
      {
        m_Patch.ForEachAround(m_Patch.From(3 * at + i),
                              [&](WallPatch::HalfEdge h) { moved = tryTriangle(h) || moved; });
      }
      else if (weights[i] == 0.0)
      {
        moved = tryTriangle(m_Patch.Twin(edge)) || moved;
      }
    }
  }
  const Point normal = Combine(nearest.weights,
                               m_Normals[m_Patch.From(3 * triangle)],
                               m_Normals[m_Patch.From(3 * triangle + 1)],
                               m_Normals[m_Patch.From(3 * triangle + 2)]);
  return { nearest.point, Normalized(normal), triangle };
}
} // namespace tissue
