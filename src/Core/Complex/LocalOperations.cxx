/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/LocalOperations.h"

#include "Complex/RelativeExterior.h"
#include "Geometry/ExactPredicates.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <limits>

namespace tissue
{
namespace
{
VertexPair
SortedPair(VertexId u, VertexId v)
{
  return { { std::min(u, v), std::max(u, v) } };
}

/** Whether corners i < k of a polygon of n corners are joined by a diagonal, not by a side. */
bool
IsDiagonal(int i, int k, int n)
{
  return k - i > 1 && k - i < n - 1;
}

/** Returns the ring's projection on the median plane of the edge from u to v, turned so that it is counterclockwise. */
std::vector<std::array<double, 2>>
ProjectRing(const std::vector<Point> & ring, const Point & u, const Point & v)
{
  const Point axis = Normalized(v - u);
  // Any direction that is not along the axis spans the plane with its normal. The coordinate axis of the smallest
  // component is far from the axis, so that the cross product is accurate.
  Point     seed{ { 0.0, 0.0, 0.0 } };
  const int smallest = static_cast<int>(
    std::min_element(axis.begin(), axis.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
    axis.begin());
  seed[smallest] = 1.0;
  const Point                        x = Normalized(Cross(axis, seed));
  const Point                        y = Cross(axis, x);
  std::vector<std::array<double, 2>> projected;
  projected.reserve(ring.size());
  for (const Point & p : ring)
  {
    projected.push_back({ { Dot(p - u, x), Dot(p - u, y) } });
  }
  return projected;
}
} // namespace

const char *
ToString(Verdict verdict)
{
  switch (verdict)
  {
    case Verdict::Legal:
      return "legal";
    case Verdict::EdgeExists:
      return "a new edge exists already";
    case Verdict::TriangleExists:
      return "the new triangle exists already";
    case Verdict::NoTriangulation:
      return "the ring has no triangulation that is allowed";
    case Verdict::Inverted:
      return "a new tetrahedron would be flat or inverted";
    case Verdict::DegreeAboveLimit:
      return "the degree of the edge is above the limit";
  }
  return "unknown";
}

LocalOperations::LocalOperations(const AdjacencyComplex & complex, const std::vector<Point> & centers,
                                 Legality legality)
  : m_Complex(complex)
  , m_Centers(centers)
  , m_Legality(legality)
  , m_MaximumDegree(std::numeric_limits<std::int32_t>::max())
{}

bool
LocalOperations::ArePositive(const Replacement & replacement, const Point & exterior) const
{
  const auto position = [&](VertexId v) -> const Point & { return v == ExteriorVertex ? exterior : m_Centers[v]; };
  return std::all_of(replacement.created.begin(), replacement.created.end(), [&](const VertexQuadruple & t) {
    return Orientation(position(t[0]), position(t[1]), position(t[2]), position(t[3])) > 0;
  });
}

Proposal
LocalOperations::SwapTriangle(TetrahedronId id, int i) const
{
  const auto &       tetrahedron = m_Complex.GetTetrahedron(id);
  const auto         neighbor = tetrahedron.neighbors[i];
  const VertexId     a = tetrahedron.vertices[i];
  const VertexId     b = m_Complex.GetTetrahedron(neighbor).vertices[m_Complex.MirrorIndex(id, i)];
  const VertexTriple t = TriangleOpposite(tetrahedron.vertices, i);

  // The swap is legal where the edge (a, b) does not exist. For geometric legality the exterior, if it is one of the
  // five vertices, is placed relative to what lies opposite to it: an edge of the triangle where it is one of the
  // triangle's corners, else the triangle.
  Proposal proposal;
  if (m_Complex.FindEdge(a, b))
  {
    proposal.verdict = Verdict::EdgeExists;
    return proposal;
  }
  Replacement & replacement = proposal.replacement;
  replacement.removed = { id, neighbor };
  for (int k = 0; k < 3; ++k)
  {
    replacement.created.push_back({ { a, b, t[k], t[(k + 1) % 3] } });
  }
  replacement.createdEdges.push_back(SortedPair(a, b));
  if (m_Legality == Legality::Geometric)
  {
    Point                  exterior{ { 0.0, 0.0, 0.0 } };
    const RelativeExterior relative(m_Complex, m_Centers);
    const auto             at = std::find(t.begin(), t.end(), ExteriorVertex);
    if (at != t.end())
    {
      const auto k = at - t.begin();
      exterior = relative.OfEdge(t[(k + 1) % 3], t[(k + 2) % 3]);
    }
    else if (a == ExteriorVertex || b == ExteriorVertex)
    {
      exterior = relative.OfTriangle(t);
    }
    if (!ArePositive(replacement, exterior))
    {
      proposal.verdict = Verdict::Inverted;
    }
  }
  return proposal;
}

Point
LocalOperations::ExteriorRelativeToEdge(VertexPair edge) const
{
  const RelativeExterior relative(m_Complex, m_Centers);
  return edge[0] == ExteriorVertex   ? relative.OfExteriorEdge(edge[1])
         : edge[1] == ExteriorVertex ? relative.OfExteriorEdge(edge[0])
                                     : relative.OfEdge(edge[0], edge[1]);
}

Proposal
LocalOperations::RemoveEdge(VertexPair edge) const
{
  const auto ring = m_Complex.GetRing(edge[0], edge[1]);
  if (static_cast<std::int32_t>(ring.vertices.size()) > m_MaximumDegree)
  {
    return { Verdict::DegreeAboveLimit, {} };
  }
  const Point        exterior = ExteriorRelativeToEdge(edge);
  const auto         position = [&](VertexId v) { return v == ExteriorVertex ? exterior : m_Centers[v]; };
  std::vector<Point> corners;
  for (const VertexId v : ring.vertices)
  {
    corners.push_back(position(v));
  }
  const auto projected = ProjectRing(corners, position(edge[0]), position(edge[1]));
  const auto cost = [&](int i, int j, int k) { return DelaunayCost(projected[i], projected[j], projected[k]); };
  return ReplaceRing(edge, ring, LeastCostTriangulation(static_cast<int>(corners.size()), cost));
}

LocalOperations::FreeDiagonals
LocalOperations::FindFreeDiagonals(const AdjacencyComplex::Ring & ring) const
{
  const int     n = static_cast<int>(ring.vertices.size());
  FreeDiagonals isFree(static_cast<std::size_t>(n * n), 1);
  for (int i = 0; i < n; ++i)
  {
    for (int k = i + 2; k < n; ++k)
    {
      isFree[i * n + k] = !IsDiagonal(i, k, n) || !m_Complex.FindEdge(ring.vertices[i], ring.vertices[k]);
    }
  }
  return isFree;
}

Proposal
LocalOperations::ReplaceRing(VertexPair edge, const AdjacencyComplex::Ring & ring,
                             const RingTriangulation & triangles) const
{
  // Each triangle of the ring becomes two tetrahedra, one with each end of the edge. This is legal where no diagonal
  // exists already, nor, in a ring of three, which has none, the triangle itself.
  const int n = static_cast<int>(ring.vertices.size());
  if (triangles.empty())
  {
    return { Verdict::NoTriangulation, {} };
  }
  if (n == 3 && m_Complex.HasTriangle(ring.vertices[0], ring.vertices[1], ring.vertices[2]))
  {
    return { Verdict::TriangleExists, {} };
  }
  Proposal      proposal;
  Replacement & replacement = proposal.replacement;
  replacement.removed.assign(ring.tetrahedra.begin(), ring.tetrahedra.end());
  replacement.removedEdges.push_back(SortedPair(edge[0], edge[1]));
  for (const auto & [i, j, k] : triangles)
  {
    const VertexId a = ring.vertices[i];
    const VertexId b = ring.vertices[j];
    const VertexId c = ring.vertices[k];
    replacement.created.push_back({ { edge[0], a, b, c } });
    replacement.created.push_back({ { edge[1], a, c, b } });
    // Each diagonal is a side of two triangles, but the side (i, k) of only that one whose third corner is between its
    // ends: so each is met once.
    if (IsDiagonal(i, k, n))
    {
      if (m_Complex.FindEdge(a, c))
      {
        return { Verdict::EdgeExists, {} };
      }
      replacement.createdEdges.push_back(SortedPair(a, c));
    }
  }
  if (m_Legality == Legality::Geometric && !ArePositive(replacement, ExteriorRelativeToEdge(edge)))
  {
    return { Verdict::Inverted, {} };
  }
  return proposal;
}
} // namespace tissue
