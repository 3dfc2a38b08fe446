/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LocalOperations_h
#define TissueTessellationCore_LocalOperations_h

#include "Complex/AdjacencyComplex.h"
#include "Geometry/PolygonTriangulation.h"
#include "TissueTessellationCore/Complex/Legality.h"

#include <limits>
#include <vector>

namespace tissue
{

/** Whether an operation is legal, or the first reason found against it. */
enum class Verdict
{
  Legal,
  /** A new edge exists already. */
  EdgeExists,
  /** The triangle that would replace an edge of degree 3 exists already. */
  TriangleExists,
  /** The ring has no triangulation that is allowed. */
  NoTriangulation,
  /** A created tetrahedron would be flat or inverted; for geometric legality only. */
  Inverted,
  /** More tetrahedra are incident to the edge than the limit allows. */
  DegreeAboveLimit
};

/** Returns the verdict in words. */
const char *
ToString(Verdict verdict);

/** An operation on one element, with its verdict. The replacement is to be used only where the verdict is Legal. */
struct Proposal
{
  Verdict     verdict = Verdict::Legal;
  Replacement replacement;

  explicit operator bool() const { return verdict == Verdict::Legal; }
};

/** \brief Proposes the local topological operations of the paper (section 3.2) on a complex, which it does not change.
 *
 * Each function lists the verdicts with which it refuses an operation. */
class LocalOperations
{
public:
  /** Both references must outlive this object. `centers` has a position for every vertex, ignored for the exterior. */
  LocalOperations(const AdjacencyComplex & complex, const std::vector<Point> & centers, Legality legality);

  /** Sets the largest degree of an edge that is removed, which is unlimited by default. */
  void
  SetMaximumDegree(std::int32_t degree)
  {
    m_MaximumDegree = degree;
  }

  /** Triangle swap (2-3 flip): the triangle of tetrahedron `id` opposite to its vertex `i` becomes the edge between
   * the two vertices that it separates. Refused: EdgeExists, Inverted. */
  Proposal
  SwapTriangle(TetrahedronId id, int i) const;

  /** Edge removal: the n tetrahedra incident to an edge become 2n - 4 over a triangulation of its ring. It is the
   * Delaunay triangulation of the ring's projection on the median plane of the edge (paper, section 3.2). The paper
   * tries no other one, so that the operation is refused where one of its diagonals exists already.
   * Refused: DegreeAboveLimit, NoTriangulation (the projected ring crosses itself), EdgeExists, TriangleExists,
   * Inverted.
   * \throws std::invalid_argument where the two vertices are not adjacent. */
  Proposal
  RemoveEdge(VertexPair edge) const;

  /** Edge removal with the triangulation of least cost among those whose diagonals do not exist yet. `cost(ring, i, j,
   * k)`, at least 0, is the cost of the triangle of the ring's vertices i < j < k.
   * Refused: DegreeAboveLimit, NoTriangulation, TriangleExists, Inverted.
   * \throws std::invalid_argument where the two vertices are not adjacent. */
  template <typename TRingCost>
  Proposal
  RemoveEdge(VertexPair edge, const TRingCost & cost) const
  {
    const AdjacencyComplex::Ring ring = m_Complex.GetRing(edge[0], edge[1]);
    const int                    n = static_cast<int>(ring.vertices.size());
    if (n > m_MaximumDegree)
    {
      return { Verdict::DegreeAboveLimit, {} };
    }
    const FreeDiagonals isFree = FindFreeDiagonals(ring);
    const auto          costIfFree = [&](int i, int j, int k) {
      return isFree[i * n + j] && isFree[j * n + k] && isFree[i * n + k] ? cost(ring, i, j, k)
                                                                                  : std::numeric_limits<double>::infinity();
    };
    return ReplaceRing(edge, ring, LeastCostTriangulation(n, costIfFree));
  }

private:
  /** At [i * n + k], for i < k: whether the ring's vertices i and k may be joined. There is room for a ring of 12
   * before memory must be allocated; larger ones are rare. */
  using FreeDiagonals = boost::container::small_vector<char, 144>;

  FreeDiagonals
  FindFreeDiagonals(const AdjacencyComplex::Ring & ring) const;

  /** Proposes the removal of an edge with a given triangulation of its ring. */
  Proposal
  ReplaceRing(VertexPair edge, const AdjacencyComplex::Ring & ring, const RingTriangulation & triangles) const;

  /** Whether all created tetrahedra are positively oriented, with the exterior at the given place. */
  bool
  ArePositive(const Replacement & replacement, const Point & exterior) const;

  Point
  ExteriorRelativeToEdge(VertexPair edge) const;

  const AdjacencyComplex &   m_Complex;
  const std::vector<Point> & m_Centers;
  Legality                   m_Legality;
  std::int32_t               m_MaximumDegree;
};
} // namespace tissue

#endif
