/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/PatchSurface.h"

#include "Geometry/NearestInTriangle.h"
#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue
{
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
    const std::int32_t    at = triangle;
    const TriangleWeights weights = nearest.weights;
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
