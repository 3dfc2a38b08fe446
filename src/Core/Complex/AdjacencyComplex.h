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
 * Apply() leaves the ids of the tetrahedra that it does not remove as they are. The ids of removed ones are given to
 * later ones. */
class AdjacencyComplex
{
public:
  struct Tetrahedron
  {
    VertexQuadruple              vertices;
    std::array<TetrahedronId, 4> neighbors;
  };

  /** An edge, with the number of tetrahedra that are incident to it, and one of them. */
  struct Edge
  {
    VertexPair    vertices;
    std::int32_t  degree;
    TetrahedronId incident;
  };

  /** The link of an edge (u, v), a cycle: tetrahedra[i] is (u, v, vertices[i], vertices[i + 1]), positively oriented.
   */
  struct Ring
  {
    Replacement::List<VertexId>      vertices;
    Replacement::List<TetrahedronId> tetrahedra;
  };

  /** Makes a complex of positively oriented tetrahedra over the vertices 0 .. numberOfVertices - 1.
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

  /** Returns the edge's record, or nullptr where u and v are not adjacent. */
  const Edge *
  FindEdge(VertexId u, VertexId v) const;

  bool
  HasTriangle(VertexId a, VertexId b, VertexId c) const;

  /** Returns the number of vertices adjacent to v, the exterior included. */
  std::int32_t
  NumberOfNeighbors(VertexId v) const
  {
    return m_NumberOfNeighbors[v];
  }

  /** Returns the link of the edge (u, v).
   * \throws std::invalid_argument where u and v are not adjacent. */
  Ring
  GetRing(VertexId u, VertexId v) const;

  /** Returns, for the neighbour across triangle i, the index of its vertex that is opposite to that triangle. */
  int
  MirrorIndex(TetrahedronId id, int i) const;

  /** Returns all edges, ascending by their vertices, the smaller one of each first. */
  std::vector<Edge>
  GetEdges() const;

  /** Returns all tetrahedra, positively oriented, in ascending order. Each is turned so that its smallest vertex comes
   * first and the smallest of the others second, so that equal complexes give the same list whatever their history. */
  std::vector<VertexQuadruple>
  GetTetrahedra() const;

  /** Returns the index in GetTetrahedra() of each tetrahedron id, and -1 for an id that is not taken. */
  std::vector<std::int32_t>
  GetTetrahedronRanks() const;

  /** Carries out the replacement and returns its inverse. A series of replacements is undone by their inverses in
   * reverse order, which restores the ids as well.
   * \throws std::logic_error where a tetrahedron to remove does not exist, or the boundaries of the removed and of the
   * created tetrahedra differ, be it in orientation; nothing is changed then. */
  Replacement
  Apply(const Replacement & replacement);

private:
  /** The neighbour of an id that is not taken, by which IsAlive() knows it: any value below 0 would do. */
  static constexpr TetrahedronId Dead = -2;

  Edge &
  EdgeOfAdjacentVertices(VertexId u, VertexId v);

  /** Adds the change, +1 or -1, to the degree of each of the tetrahedron's six edges; edges come and go with it. */
  void
  CountEdges(const VertexQuadruple & vertices, TetrahedronId id, int change);

  /** Returns an id that is not taken, the one freed last if there is one. */
  TetrahedronId
  Allocate();

  std::vector<Tetrahedron>   m_Tetrahedra;
  std::vector<TetrahedronId> m_Free;
  /** For each vertex, its edges to vertices of smaller index. The lists are short, since the exterior, which has most
   * edges, is vertex 0. */
  std::vector<std::vector<Edge>> m_Edges;
  std::vector<std::int32_t>      m_NumberOfNeighbors;
  std::size_t                    m_NumberOfEdges = 0;
};

/** Returns the vertices of triangle i of a positively oriented tetrahedron, counterclockwise seen from outside. */
VertexTriple
TriangleOpposite(const VertexQuadruple & tetrahedron, int i);

/** Returns the same tetrahedron, turned as AdjacencyComplex::GetTetrahedra() promises. */
VertexQuadruple
Canonical(const VertexQuadruple & tetrahedron);
} // namespace tissue

#endif
