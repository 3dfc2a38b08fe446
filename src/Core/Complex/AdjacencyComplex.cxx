/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/AdjacencyComplex.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace tissue
{
namespace
{
/** A triangle as one of its two tetrahedra sees it. */
struct Side
{
  VertexTriple  triangle; // Its vertices ascend.
  bool          isEven;   // Whether their ascending order is counterclockwise, seen from outside the tetrahedron.
  TetrahedronId tetrahedron;
  int           opposite; // The index of the tetrahedron's vertex that is not in the triangle.
};

Side
MakeSide(const VertexQuadruple & vertices, TetrahedronId tetrahedron, int opposite)
{
  VertexTriple t = TriangleOpposite(vertices, opposite);
  const int    ascents = (t[0] < t[1]) + (t[1] < t[2]) + (t[0] < t[2]);
  std::sort(t.begin(), t.end());
  return { t, ascents % 2 == 1, tetrahedron, opposite };
}

/** Sorts the sides and tells whether every triangle has exactly two, of opposite orientations. */
template <typename TSides>
bool
PairUp(TSides & sides)
{
  std::sort(sides.begin(), sides.end(), [](const Side & a, const Side & b) { return a.triangle < b.triangle; });
  for (std::size_t i = 0; i < sides.size(); i += 2)
  {
    const bool paired = i + 1 < sides.size() && sides[i].triangle == sides[i + 1].triangle;
    const bool single = i + 2 >= sides.size() || sides[i].triangle != sides[i + 2].triangle;
    if (!paired || !single || sides[i].isEven == sides[i + 1].isEven)
    {
      return false;
    }
  }
  return true;
}

/** Makes the two tetrahedra of each triangle neighbours. */
template <typename TTetrahedra, typename TSides>
void
Link(TTetrahedra & tetrahedra, const TSides & pairedSides)
{
  for (std::size_t i = 0; i < pairedSides.size(); i += 2)
  {
    const Side & a = pairedSides[i];
    const Side & b = pairedSides[i + 1];
    tetrahedra[a.tetrahedron].neighbors[a.opposite] = b.tetrahedron;
    tetrahedra[b.tetrahedron].neighbors[b.opposite] = a.tetrahedron;
  }
}
} // namespace

VertexTriple
TriangleOpposite(const VertexQuadruple & t, int i)
{
  static constexpr int order[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
  return { { t[order[i][0]], t[order[i][1]], t[order[i][2]] } };
}

VertexQuadruple
Canonical(const VertexQuadruple & t)
{
  const int    first = static_cast<int>(std::min_element(t.begin(), t.end()) - t.begin());
  VertexTriple others = TriangleOpposite(t, first);
  std::rotate(others.begin(), std::min_element(others.begin(), others.end()), others.end());
  return { { t[first], others[0], others[1], others[2] } };
}

AdjacencyComplex::AdjacencyComplex(VertexId numberOfVertices, const std::vector<VertexQuadruple> & tetrahedra)
  : m_Edges(static_cast<std::size_t>(numberOfVertices))
  , m_NumberOfNeighbors(static_cast<std::size_t>(numberOfVertices), 0)
{
  std::vector<Side> sides;
  sides.reserve(4 * tetrahedra.size());
  m_Tetrahedra.reserve(tetrahedra.size());
  for (const VertexQuadruple & vertices : tetrahedra)
  {
    const auto id = static_cast<TetrahedronId>(m_Tetrahedra.size());
    m_Tetrahedra.push_back({ vertices, {} });
    for (int i = 0; i < 4; ++i)
    {
      if (vertices[i] < 0 || vertices[i] >= numberOfVertices)
      {
        throw std::invalid_argument("AdjacencyComplex: vertex " + std::to_string(vertices[i]) + " of tetrahedron " +
                                    std::to_string(id) + " is not in 0 .. " + std::to_string(numberOfVertices - 1));
      }
      sides.push_back(MakeSide(vertices, id, i));
    }
    CountEdges(vertices, id, +1);
  }
  if (!PairUp(sides))
  {
    throw std::invalid_argument("AdjacencyComplex: a triangle is not in exactly two tetrahedra, oriented alike");
  }
  Link(m_Tetrahedra, sides);
}

const AdjacencyComplex::Edge *
AdjacencyComplex::FindEdge(VertexId u, VertexId v) const
{
  if (u > v)
  {
    std::swap(u, v);
  }
  for (const Edge & edge : m_Edges[v])
  {
    if (edge.vertices[0] == u)
    {
      return &edge;
    }
  }
  return nullptr;
}

AdjacencyComplex::Edge &
AdjacencyComplex::EdgeOfAdjacentVertices(VertexId u, VertexId v)
{
  return const_cast<Edge &>(*FindEdge(u, v));
}

bool
AdjacencyComplex::HasTriangle(VertexId a, VertexId b, VertexId c) const
{
  if (!FindEdge(a, b) || !FindEdge(b, c) || !FindEdge(a, c))
  {
    return false;
  }
  const Ring ring = GetRing(a, b);
  return std::find(ring.vertices.begin(), ring.vertices.end(), c) != ring.vertices.end();
}

AdjacencyComplex::Ring
AdjacencyComplex::GetRing(VertexId u, VertexId v) const
{
  const Edge * const edge = FindEdge(u, v);
  if (!edge)
  {
    throw std::invalid_argument("AdjacencyComplex::GetRing: vertices " + std::to_string(u) + " and " +
                                std::to_string(v) + " are not adjacent");
  }
  Ring          ring;
  TetrahedronId id = edge->incident;
  do
  {
    const Tetrahedron & t = m_Tetrahedra[id];
    // Write the tetrahedron as (u, v, p, q): seen from u, the others are v, p, q in this cyclic order.
    const int    atU = static_cast<int>(std::find(t.vertices.begin(), t.vertices.end(), u) - t.vertices.begin());
    VertexTriple others = TriangleOpposite(t.vertices, atU);
    std::rotate(others.begin(), std::find(others.begin(), others.end(), v), others.end());
    ring.vertices.push_back(others[1]);
    ring.tetrahedra.push_back(id);
    const int atP = static_cast<int>(std::find(t.vertices.begin(), t.vertices.end(), others[1]) - t.vertices.begin());
    id = t.neighbors[atP];
  } while (id != edge->incident);
  return ring;
}

int
AdjacencyComplex::MirrorIndex(TetrahedronId id, int i) const
{
  const auto & back = m_Tetrahedra[m_Tetrahedra[id].neighbors[i]];
  const auto   triangle = TriangleOpposite(m_Tetrahedra[id].vertices, i);
  for (int j = 0; j < 4; ++j)
  {
    if (std::find(triangle.begin(), triangle.end(), back.vertices[j]) == triangle.end())
    {
      return j;
    }
  }
  throw std::logic_error("AdjacencyComplex::MirrorIndex: two tetrahedra with the same four vertices");
}

std::vector<AdjacencyComplex::Edge>
AdjacencyComplex::GetEdges() const
{
  std::vector<Edge> edges;
  edges.reserve(m_NumberOfEdges);
  for (const auto & list : m_Edges)
  {
    edges.insert(edges.end(), list.begin(), list.end());
  }
  std::sort(edges.begin(), edges.end(), [](const Edge & a, const Edge & b) { return a.vertices < b.vertices; });
  return edges;
}

std::vector<VertexQuadruple>
AdjacencyComplex::GetTetrahedra() const
{
  std::vector<VertexQuadruple> tetrahedra;
  tetrahedra.reserve(NumberOfTetrahedra());
  for (TetrahedronId id = 0; id < TetrahedronIdBound(); ++id)
  {
    if (IsAlive(id))
    {
      tetrahedra.push_back(Canonical(m_Tetrahedra[id].vertices));
    }
  }
  std::sort(tetrahedra.begin(), tetrahedra.end());
  return tetrahedra;
}

std::vector<std::int32_t>
AdjacencyComplex::GetTetrahedronRanks() const
{
  const std::vector<VertexQuadruple> tetrahedra = GetTetrahedra();
  std::vector<std::int32_t>          ranks(m_Tetrahedra.size(), -1);
  for (TetrahedronId id = 0; id < TetrahedronIdBound(); ++id)
  {
    if (IsAlive(id))
    {
      const auto at = std::lower_bound(tetrahedra.begin(), tetrahedra.end(), Canonical(m_Tetrahedra[id].vertices));
      ranks[id] = static_cast<std::int32_t>(at - tetrahedra.begin());
    }
  }
  return ranks;
}

void
AdjacencyComplex::CountEdges(const VertexQuadruple & vertices, TetrahedronId id, int change)
{
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      const VertexId u = std::min(vertices[i], vertices[j]);
      const VertexId v = std::max(vertices[i], vertices[j]);
      if (!FindEdge(u, v))
      {
        m_Edges[v].push_back({ { { u, v } }, 0, id });
        ++m_NumberOfNeighbors[u];
        ++m_NumberOfNeighbors[v];
        ++m_NumberOfEdges;
      }
      Edge & edge = EdgeOfAdjacentVertices(u, v);
      edge.degree += change;
      if (edge.degree == 0)
      {
        edge = m_Edges[v].back();
        m_Edges[v].pop_back();
        --m_NumberOfNeighbors[u];
        --m_NumberOfNeighbors[v];
        --m_NumberOfEdges;
      }
      else if (change > 0)
      {
        edge.incident = id;
      }
    }
  }
}

TetrahedronId
AdjacencyComplex::Allocate()
{
  if (m_Free.empty())
  {
    m_Tetrahedra.push_back({});
    return static_cast<TetrahedronId>(m_Tetrahedra.size() - 1);
  }
  const TetrahedronId id = m_Free.back();
  m_Free.pop_back();
  return id;
}

Replacement
AdjacencyComplex::Apply(const Replacement & replacement)
{
  // First the check, which changes nothing: the outer sides of the removed tetrahedra's boundary and the sides of the
  // created ones must pair up. Created tetrahedra have ids after all others until then. Room for 64 sides is what the
  // removal of an edge of degree 8 needs, 2 n + 4 (2 n - 4).
  const TetrahedronId                      provisional = TetrahedronIdBound();
  boost::container::small_vector<Side, 64> sides;
  const auto                               isRemoved = [&replacement](TetrahedronId id) {
    return std::find(replacement.removed.begin(), replacement.removed.end(), id) != replacement.removed.end();
  };
  for (const TetrahedronId id : replacement.removed)
  {
    if (id < 0 || id >= provisional || !IsAlive(id))
    {
      throw std::logic_error("AdjacencyComplex::Apply: there is no tetrahedron " + std::to_string(id) + " to remove");
    }
    for (int i = 0; i < 4; ++i)
    {
      const TetrahedronId outside = m_Tetrahedra[id].neighbors[i];
      if (!isRemoved(outside))
      {
        const int mirror = MirrorIndex(id, i);
        sides.push_back(MakeSide(m_Tetrahedra[outside].vertices, outside, mirror));
      }
    }
  }
  for (std::size_t k = 0; k < replacement.created.size(); ++k)
  {
    for (int i = 0; i < 4; ++i)
    {
      sides.push_back(MakeSide(replacement.created[k], provisional + static_cast<TetrahedronId>(k), i));
    }
  }
  if (!PairUp(sides))
  {
    throw std::logic_error("AdjacencyComplex::Apply: removed and created tetrahedra have not the same boundary");
  }

  // Then the change: the ids of the removed tetrahedra are freed, the created ones take them, the records of the edges
  // follow, and the pairs of sides become neighbours.
  Replacement inverse;
  inverse.createdEdges = replacement.removedEdges;
  inverse.removedEdges = replacement.createdEdges;
  for (const TetrahedronId id : replacement.removed)
  {
    inverse.created.push_back(m_Tetrahedra[id].vertices);
    m_Tetrahedra[id].neighbors.fill(Dead);
  }
  // In this order the inverse gives every tetrahedron its old id again.
  m_Free.insert(m_Free.end(), replacement.removed.rbegin(), replacement.removed.rend());
  for (const VertexQuadruple & vertices : replacement.created)
  {
    const TetrahedronId id = Allocate();
    m_Tetrahedra[id].vertices = vertices;
    inverse.removed.push_back(id);
    // Counting up before down keeps the records of the edges that stay.
    CountEdges(vertices, id, +1);
  }
  for (const VertexQuadruple & vertices : inverse.created)
  {
    CountEdges(vertices, Dead, -1);
  }
  for (Side & side : sides)
  {
    if (side.tetrahedron >= provisional)
    {
      side.tetrahedron = inverse.removed[static_cast<std::size_t>(side.tetrahedron - provisional)];
    }
  }
  Link(m_Tetrahedra, sides);
  return inverse;
}
} // namespace tissue
