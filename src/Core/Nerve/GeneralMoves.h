/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_GeneralMoves_h
#define TissueTessellationCore_GeneralMoves_h

#include "Geometry/PolygonTriangulation.h"
#include "Nerve/GeneralMove.h"

namespace tissue
{
/** Whether a move of a general complex is legal, or why it is not. */
enum class MoveVerdict
{
  Legal,
  /** A new edge would join a vertex to itself. */
  JoinsVertexToItself,
  /** The ring has no triangulation that is allowed. */
  NoTriangulation,
  /** The edge has not as many tetrahedra around it as the move is for. */
  WrongDegree,
  /** The two edges to be merged are one. */
  SameEdge,
  /** The two triangles to be opened are one. */
  SameTriangle,
  /** The two triangles have not the vertices in common that the move is for. */
  DifferentVertices
};

const char *
ToString(MoveVerdict verdict);

/** A move with its verdict; the move is filled in where it is legal. */
struct MoveProposal
{
  MoveVerdict verdict = MoveVerdict::Legal;
  GeneralMove move;

  explicit operator bool() const { return verdict == MoveVerdict::Legal; }
};

/** \name The moves of a general complex: proposals that change nothing.
 *
 * The first four leave every link what it is, component for component and genus for genus. The others join and split:
 * they are for the repair (NerveRepair.h), and for making a complex.
 * @{ */

/** 2-3: the triangle becomes an edge between the two vertices that it separates. Refused: JoinsVertexToItself. */
MoveProposal
SwapTriangle(const GeneralComplex & complex, const Side & triangle);

/** Edge removal, 3-2 for a ring of three: the n >= 3 tetrahedra around the edge become 2n - 4 over a triangulation of
 * its ring, by indices in GetRing(edge). Refused: WrongDegree (n = 2), NoTriangulation (none is given),
 * JoinsVertexToItself (a diagonal joins equal vertices). */
MoveProposal
RemoveEdge(const GeneralComplex & complex, const LocalEdge & edge, const RingTriangulation & triangles);

/** 2-0: an edge with two tetrahedra around it goes, with both; what was on either side of them is glued. The edges that
 * the two have opposite to it become one. Refused: WrongDegree, SameEdge (these are one already). */
MoveProposal
CloseEdge(const GeneralComplex & complex, const LocalEdge & edge);

/** 0-2, the inverse: an edge is split in two along the triangles i and j of its ring (those with the ring's vertices i
 * and j), and two tetrahedra around a new edge between these vertices keep the two apart. Refused: SameTriangle,
 * JoinsVertexToItself. */
MoveProposal
SplitEdge(const GeneralComplex & complex, const EdgeRing & ring, std::size_t i, std::size_t j);

/** 0-2 on two edges (a, b), which become one: triangle i of the first's ring and triangle j of the second's are opened,
 * and two tetrahedra around a new edge between their third vertices join them. Where a's links at the two edges are two
 * they become one, by a connected sum; where they are one, a's link gets a handle; for b likewise. Refused:
 * DifferentVertices (the edges' ends, from and to), JoinsVertexToItself. The two edges must not be one: see SplitEdge.
 */
MoveProposal
JoinEdges(const GeneralComplex & complex, const EdgeRing & first, std::size_t i, const EdgeRing & second,
          std::size_t j);

/** Two triangles of the same three vertices are opened and glued crosswise. Refused: DifferentVertices, SameTriangle.
 * The differences of edges are not filled in: they depend on which of their edges are one. */
MoveProposal
ReglueCrosswise(const GeneralComplex & complex, const Side & first, const Side & second);

/** Two triangles (a, b, c) and (a, d, e) of five different vertices, a the common one, are opened and joined by four
 * tetrahedra: a's links at the two become one, by a connected sum, and all others stay what they are. The last resort
 * where two parts of a complex have but one cell in common: it makes three edges, between b, c and d, e. Refused:
 * DifferentVertices (the two have not just one in common). */
MoveProposal
BridgeTriangles(const GeneralComplex & complex, const Side & first, const Side & second);

/** A handle of the link of a vertex a is cut along a loop of k vertices: triangle i is (a, vertices[i], vertices[i +
 * 1]), cyclic. All k are opened, and each of the two sides is closed by a fan of k - 2 tetrahedra around the first
 * vertex; the two fans are glued to each other. A loop of two triangles is glued crosswise. Refused:
 * JoinsVertexToItself (the first vertex comes again), SameTriangle and DifferentVertices as ReglueCrosswise(). */
MoveProposal
CutAlongLoop(const GeneralComplex & complex, VertexId a, const std::vector<Side> & triangles,
             const std::vector<VertexId> & vertices);

/** A triangle is opened and filled by two tetrahedra with a vertex that is in none yet: a cell that touches three
 * others, by one wall each. Refused: JoinsVertexToItself (the vertex is one of the triangle's). */
MoveProposal
InsertPillow(const GeneralComplex & complex, const Side & triangle, VertexId vertex);
/** @} */

/** Whether the pieces of each cell together stay what they are, in pieces and handles: of several vertices of one cell,
 * the complex that they span keeps its Euler characteristic. Of the first four moves alone.
 * \param cellOf the cell of each vertex; without entries each is a cell of its own, and no move changes it. */
bool
KeepsTopology(const GeneralComplex & complex, const GeneralMove & move, const std::vector<VertexId> & cellOf);
} // namespace tissue

#endif
