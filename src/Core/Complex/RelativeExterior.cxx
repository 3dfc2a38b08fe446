/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/RelativeExterior.h"

#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue
{
Point
RelativeExterior::Normal(VertexId vertex) const
{
  Point sum{ { 0.0, 0.0, 0.0 } };
  if (!m_Complex.FindEdge(ExteriorVertex, vertex))
  {
    return sum;
  }
  // The tetrahedra (exterior, vertex, p, q) are positive, so seen from the exterior (vertex, p, q) is clockwise.
  const AdjacencyComplex::Ring ring = m_Complex.GetRing(ExteriorVertex, vertex);
  const std::size_t            n = ring.vertices.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point p = m_Centers[ring.vertices[i]] - m_Centers[vertex];
    const Point q = m_Centers[ring.vertices[(i + 1) % n]] - m_Centers[vertex];
    sum = sum + Cross(q, p);
  }
  return Normalized(sum);
}

std::vector<Point>
RelativeExterior::Normals() const
{
  std::vector<Point> normals(m_Centers.size(), Point{ { 0.0, 0.0, 0.0 } });
  for (VertexId v = ExteriorVertex + 1; v < m_Complex.NumberOfVertices(); ++v)
  {
    normals[v] = this->Normal(v);
  }
  return normals;
}

Point
RelativeExterior::OfExteriorEdge(VertexId vertex) const
{
  const AdjacencyComplex::Ring ring = m_Complex.GetRing(ExteriorVertex, vertex);
  double                       distance = 0.0;
  for (const VertexId other : ring.vertices)
  {
    distance += Distance(m_Centers[vertex], m_Centers[other]);
  }
  return m_Centers[vertex] + (distance / static_cast<double>(ring.vertices.size())) * Normal(vertex);
}

Point
RelativeExterior::OfEdge(VertexId u, VertexId v) const
{
  const Point middle = 0.5 * (m_Centers[u] + m_Centers[v]);
  return middle + Distance(m_Centers[u], m_Centers[v]) * Normalized(Normal(u) + Normal(v));
}

Point
RelativeExterior::OfTriangle(const VertexTriple & t) const
{
  const Point & a = m_Centers[t[0]];
  const Point & b = m_Centers[t[1]];
  const Point & c = m_Centers[t[2]];
  const double  meanEdge = (Distance(a, b) + Distance(b, c) + Distance(c, a)) / 3.0;
  return (1.0 / 3.0) * (a + b + c) + meanEdge * Normalized(Normal(t[0]) + Normal(t[1]) + Normal(t[2]));
}
} // namespace tissue
