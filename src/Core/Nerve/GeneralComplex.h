/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_GeneralComplex_h
#define TissueTessellationCore_GeneralComplex_h

#include "Complex/Replacement.h"

#include <algorithm>
#include <array>
#include <vector>

namespace tissue
{
struct GeneralMove;

/** Index of a line of the image that a triangle of the complex stands for. */
using LineId = std::int32_t;
/** Index of a corner of the image that a tetrahedron of the complex stands for. */
using CornerId = std::int32_t;
/** The line or corner of what no place of the image stands behind: a move has made it. */
constexpr std::int32_t NoPlace = -1;

/** \brief A triangle seen from one of the two tetrahedra that it separates: the one opposite to a local vertex. */
struct Side
{
  TetrahedronId tetrahedron = -1;
  int           opposite = 0;

  friend bool
  operator==(const Side & a, const Side & b)
  {
    return a.tetrahedron == b.tetrahedron && a.opposite == b.opposite;
  }
};

/** \brief An edge as one of the tetrahedra around it sees it: from one local vertex to another. */
struct LocalEdge
{
  TetrahedronId tetrahedron = -1;
  int           from = 0;
  int           to = 1;
};

/** \brief One of the tetrahedra around an edge: (from, to, here, next) is positively oriented, where `here` and `next`
 * are consecutive vertices of the edge's link. All four are local vertices. */
struct RingStep
{
  TetrahedronId tetrahedron = -1;
  int           from = 0;
  int           to = 1;
  int           here = 2;
  int           next = 3;
};

/** The tetrahedra around an edge, in cyclic order. */
using EdgeRing = boost::container::small_vector<RingStep, 12>;

/** \brief A generalized triangulation: tetrahedra glued along their triangles, where several edges may join two
 * vertices and several triangles three.
 *
 * The cells of a tissue are its vertices, its walls the edges, its lines the triangles, its corners the tetrahedra. A
 * simplicial complex can say that two cells touch, this one also how often: two cells with two walls in common are
 * joined by two edges.
 *
 * The four vertices of a tetrahedron are different. That is all that keeps it simple: the triangle of three given
 * vertices is at most one of a tetrahedron's, so two glued tetrahedra need no record of how they are glued, and there
 * is no hash of edges or triangles. An edge is known by a tetrahedron that has it, and found whole by walking around
 * it.
 *
 * Tetrahedra are oriented: (a, b, c, d) and its even permutations are the same one. With positions, a positive one has
 * det(b - a, c - a, d - a) > 0. `neighbors[i]` is across the triangle opposite to `vertices[i]`.
 *
 * The class is pure combinatorics. That the link of each cell is a sphere is not its business but that of
 * FindViolations(), and is kept by the moves (GeneralMoves.h). It also carries what in the image stands behind each
 * tetrahedron and triangle, so that the dual can put it there. */
class GeneralComplex
{
public:
  struct Tetrahedron
  {
    VertexQuadruple              vertices;
    std::array<TetrahedronId, 4> neighbors;
    /** Of the triangles opposite to the vertices: the same number from both sides. */
    std::array<LineId, 4> lines;
    CornerId              corner;
  };

  /** An edge: its vertices ascending, the number of tetrahedra around it, and one of them. */
  struct Edge
  {
    VertexPair   vertices;
    std::int32_t degree;
    LocalEdge    local;
  };

  /** Without tetrahedra, over the vertices 0 ... numberOfVertices - 1. */
  explicit GeneralComplex(VertexId numberOfVertices = 0)
    : m_NumberOfVertices(numberOfVertices)
  {}

  VertexId
  NumberOfVertices() const
  {
    return m_NumberOfVertices;
  }

  /** A vertex that is no cell but a part of the exterior, as ExteriorVertex is: any link is right for it. */
  bool
  IsOutside(VertexId v) const
  {
    return v == ExteriorVertex || std::binary_search(m_Outside.begin(), m_Outside.end(), v);
  }

  /** Makes vertices outside ones beside ExteriorVertex; ascending. */
  void
  SetOutside(std::vector<VertexId> vertices)
  {
    m_Outside = std::move(vertices);
  }

  std::size_t
  NumberOfTetrahedra() const
  {
    return m_Tetrahedra.size() - m_Free.size();
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

  VertexId
  VertexOpposite(const Side & side) const
  {
    return m_Tetrahedra[side.tetrahedron].vertices[side.opposite];
  }

  /** The same triangle from its other side; the triangle must be glued. */
  Side
  GetMate(const Side & side) const;

  /** The tetrahedra around an edge, from the given one on. */
  EdgeRing
  GetRing(const LocalEdge & edge) const;

  /** The vertices of the edge's link, in the order of the ring. */
  boost::container::small_vector<VertexId, 12>
  GetRingVertices(const EdgeRing & ring) const;

  /** All edges, each once, in the order of the first tetrahedron that has them. */
  std::vector<Edge>
  FindEdges() const;

  /** The same complex with its tetrahedra in this order, which has each id that is taken once: they become 0, 1, ... */
  GeneralComplex
  InOrder(const std::vector<TetrahedronId> & order) const;

  /** Takes the memory for so many tetrahedra at once. */
  void
  Reserve(std::size_t numberOfTetrahedra)
  {
    m_Tetrahedra.reserve(numberOfTetrahedra);
  }

  /** Adds a tetrahedron that is glued to nothing yet.
   * \throws std::invalid_argument where a vertex is out of range or there twice. */
  TetrahedronId
  Add(const VertexQuadruple & vertices, CornerId corner = NoPlace);

  /** Glues two tetrahedra along a triangle.
   * \throws std::invalid_argument where the two do not have the three vertices in common, or are not oriented alike. */
  void
  Glue(const Side & a, const Side & b, LineId line = NoPlace);

  /** Takes tetrahedra out, whose neighbours among the others are then glued to nothing on that side. */
  void
  Remove(const std::vector<TetrahedronId> & ids);

  /** Carries out the move and returns its inverse. A series of moves is undone by their inverses in reverse order,
   * which restores the ids as well.
   * \throws std::logic_error where a tetrahedron to remove does not exist, or two triangles to be glued do not match;
   * nothing is changed. */
  GeneralMove
  Apply(const GeneralMove & move);

  /** Whether the triangles of two tetrahedra opposite to local vertices i and j have the same vertices, with opposite
   * orientations. */
  static bool
  AreGluable(const VertexQuadruple & a, int i, const VertexQuadruple & b, int j);

private:
  static constexpr TetrahedronId Dead = -2;
  static constexpr TetrahedronId Unglued = -1;

  GeneralMove
  InverseOf(const GeneralMove & move) const;

  void
  CheckMove(const GeneralMove & move) const;

  TetrahedronId
  Allocate();

  VertexId                   m_NumberOfVertices;
  std::vector<VertexId>      m_Outside;
  std::vector<Tetrahedron>   m_Tetrahedra;
  std::vector<TetrahedronId> m_Free;
};

/** Index of a vertex in a tetrahedron, -1 where it is none of its vertices. */
inline int
LocalIndex(const VertexQuadruple & vertices, VertexId v)
{
  for (int i = 0; i < 4; ++i)
  {
    if (vertices[i] == v)
    {
      return i;
    }
  }
  return -1;
}

inline bool
AreDifferent(const VertexQuadruple & vertices)
{
  return LocalIndex(vertices, vertices[1]) == 1 && LocalIndex(vertices, vertices[2]) == 2 &&
         LocalIndex(vertices, vertices[3]) == 3;
}

/** The other two local vertices k, l of a tetrahedron, such that (i, j, k, l) is an even permutation of 0 ... 3. */
std::array<int, 2>
EvenComplement(int i, int j);

/** Whether p is an even permutation of 0 ... 3. */
bool
IsEven(const std::array<int, 4> & p);
} // namespace tissue

#endif
