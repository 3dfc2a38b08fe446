/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_AdjacencyComplex_h
#define TissueTessellationCore_AdjacencyComplex_h

#include "Complex/Replacement.h"

#include <vector>

namespace tissue
{
/** \brief The adjacency complex of a tissue (paper, section 3.1): cells are vertices, tetrahedra are four cells that
 * meet.
 *
 * With the exterior as a vertex like the others (section 3.3) the complex is closed: every triangle is in exactly two
 * tetrahedra and every vertex link is a 2-sphere, so every operation is one in the interior. The class is pure
 * combinatorics: no positions, and no judgement of what a change is worth.
 *
 * Tetrahedra are oriented: (a, b, c, d) and its even permutations are the same one. With positions, a positive
 * tetrahedron has det(b - a, c - a, d - a) > 0. `neighbors[i]` is across the triangle opposite to `vertices[i]`.
 *
 * What survives Apply(): ids of the tetrahedra that are not removed. The ids of removed ones are given to later ones.
 */
class AdjacencyComplex
{
public:
  struct Tetrahedron
  {
    VertexQuadruple              vertices;
    std::array<TetrahedronId, 4> neighbors;
  };

  /** An edge: its vertices, the number of tetrahedra incident to it, and one of them. */
  struct Edge
  {
    VertexPair    vertices;
    std::int32_t  degree;
    TetrahedronId incident;
  };

  /** The link of an edge (u, v): the tetrahedra (u, v, vertices[i], vertices[i + 1]), positively oriented, cyclic. */
  struct Ring
  {
    Replacement::List<VertexId>      vertices;
    Replacement::List<TetrahedronId> tetrahedra;
  };

  /** From positively oriented tetrahedra over the vertices 0 .. numberOfVertices - 1.
   * \throws std::invalid_argument where a triangle is not in exactly two of them, the two are not oriented alike, or a
   * vertex is out of range. */
  AdjacencyComplex(VertexId numberOfVertices, const std::vector<VertexQuadruple> & tetrahedra);

  VertexId
  NumberOfVertices() const
  {
    return static_cast<VertexId>(m_Edges.size());
  }

  std::size_t
  NumberOfTetrahedra() const
  {
    return m_Tetrahedra.size() - m_Free.size();
  }

  std::size_t
  NumberOfEdges() const
  {
    return m_NumberOfEdges;
  }

  /** Every id is below this bound; IsAlive() tells which ones are taken. */
  TetrahedronId
  TetrahedronIdBound() const
  {
    return static_cast<TetrahedronId>(m_Tetrahedra.size());
  }

  bool
  IsAlive(TetrahedronId id) const
  {
    return m_Tetrahedra[id].neighbors[0] != Dead;
  }

  const Tetrahedron &
  GetTetrahedron(TetrahedronId id) const
  {
    return m_Tetrahedra[id];
  }

  /** The edge's record, or nullptr where u and v are not adjacent. */
  const Edge *
  FindEdge(VertexId u, VertexId v) const;

  bool
  HasTriangle(VertexId a, VertexId b, VertexId c) const;

  /** Number of vertices adjacent to v, the exterior included. */
  std::int32_t
  NumberOfNeighbors(VertexId v) const
  {
    return m_NumberOfNeighbors[v];
  }

  /** A tetrahedron incident to the vertex.
   * \throws std::invalid_argument where there is none. */
  TetrahedronId
  FindIncidentTetrahedron(VertexId v) const;

  /** All tetrahedra incident to the vertex, each once, in an order that depends on the history. */
  std::vector<TetrahedronId>
  GetStar(VertexId v) const;

  /** The link of the edge (u, v).
   * \throws std::invalid_argument where u and v are not adjacent. */
  Ring
  GetRing(VertexId u, VertexId v) const;

  /** Index in the neighbour across triangle i of the vertex that is opposite to that triangle. */
  int
  MirrorIndex(TetrahedronId id, int i) const;

  /** All edges, ascending by their vertices (the smaller one first). */
  std::vector<Edge>
  GetEdges() const;

  /** All tetrahedra, positively oriented, ascending, each turned so that its smallest vertex comes first and the
   * smallest of the others second: the same for equal complexes whatever their history. */
  std::vector<VertexQuadruple>
  GetTetrahedra() const;

  /** Of each tetrahedron id, its index in GetTetrahedra(); -1 of an id that is not taken. */
  std::vector<std::int32_t>
  GetTetrahedronRanks() const;

  /** Carries out the replacement and returns its inverse. A series of replacements is undone by their inverses in
   * reverse order, which restores the ids as well.
   * \throws std::logic_error where a tetrahedron to remove does not exist, or removed and created tetrahedra have not
   * the same boundary, orientation included; nothing is changed. */
  Replacement
  Apply(const Replacement & replacement);

private:
  static constexpr TetrahedronId Dead = -2;

  Edge &
  EdgeOfAdjacentVertices(VertexId u, VertexId v);

  void
  CountEdges(const VertexQuadruple & vertices, TetrahedronId id, int change);

  TetrahedronId
  Allocate();

  std::vector<Tetrahedron>   m_Tetrahedra;
  std::vector<TetrahedronId> m_Free;
  /** The edges of each vertex to those of smaller index: short lists, as the exterior is vertex 0. */
  std::vector<std::vector<Edge>> m_Edges;
  std::vector<std::int32_t>      m_NumberOfNeighbors;
  std::size_t                    m_NumberOfEdges = 0;
};

/** The vertices of triangle i of a positively oriented tetrahedron, counterclockwise seen from outside. */
VertexTriple
TriangleOpposite(const VertexQuadruple & tetrahedron, int i);

/** The same tetrahedron by the even permutation that AdjacencyComplex::GetTetrahedra() promises. */
VertexQuadruple
Canonical(const VertexQuadruple & tetrahedron);
} // namespace tissue

#endif
