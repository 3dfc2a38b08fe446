/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/GeneralMoves.h"
#include "Nerve/MoveParts.h"

// The moves that open triangles: they may join and split links.
namespace tissue
{
namespace
{
/** The two sides of triangle i of an edge's ring, whose vertices are from, to and the ring's vertex i. */
struct TwoSides
{
  Side     plus;  // of the tetrahedron (from, to, i, i + 1)
  Side     minus; // of the tetrahedron (from, to, i - 1, i)
  VertexId third;
};

TwoSides
SidesOf(const GeneralComplex & complex, const EdgeRing & ring, std::size_t i)
{
  const RingStep & after = ring[i];
  const RingStep & before = ring[(i + ring.size() - 1) % ring.size()];
  return { { after.tetrahedron, after.next },
           { before.tetrahedron, before.here },
           complex.GetTetrahedron(after.tetrahedron).vertices[after.here] };
}

/** Opens a triangle of each of two edges (a, b) and puts two tetrahedra around a new edge between. */
GeneralMove
InsertDigon(const GeneralComplex & complex, VertexPair ends, const TwoSides & first, const TwoSides & second)
{
  const auto [a, b] = ends;
  const VertexId x = first.third;
  const VertexId y = second.third;
  GeneralMove    move;
  move.created.push_back({ { { a, b, x, y } } });
  move.created.push_back({ { { b, a, x, y } } });
  move.gluings.push_back({ CreatedSide(0, 0), CreatedSide(1, 1) });
  move.gluings.push_back({ CreatedSide(0, 1), CreatedSide(1, 0) });
  // A triangle that is opened becomes two; the image has its line once.
  move.gluings.push_back({ CreatedSide(0, 3), first.minus, LineOf(complex, first.minus) });
  move.gluings.push_back({ CreatedSide(1, 3), first.plus });
  move.gluings.push_back({ CreatedSide(0, 2), second.plus, LineOf(complex, second.plus) });
  move.gluings.push_back({ CreatedSide(1, 2), second.minus });
  move.createdEdges.push_back(Ascending(x, y));
  return move;
}

/** A pyramid with the apex a over the quadrilateral b, c, e, d on each side of the two triangles, which are glued to
 * each other wherever they do not meet the triangles. */
GeneralMove
MakeBridge(const GeneralComplex & complex, const std::array<VertexId, 3> & own, const std::array<VertexId, 3> & other,
           const Side & first, const Side & second)
{
  const auto [a, b, c] = own;
  const auto [same, d, e] = other;
  GeneralMove move;
  move.created.push_back({ { { a, b, c, e } } });
  move.created.push_back({ { { a, b, e, d } } });
  move.created.push_back({ { { b, a, c, e } } });
  move.created.push_back({ { { b, a, e, d } } });
  // Within the pyramids, their bases, and their sides (a, c, e) and (a, b, d).
  move.gluings.push_back({ CreatedSide(0, 2), CreatedSide(1, 3) });
  move.gluings.push_back({ CreatedSide(2, 2), CreatedSide(3, 3) });
  move.gluings.push_back({ CreatedSide(0, 0), CreatedSide(2, 1) });
  move.gluings.push_back({ CreatedSide(1, 0), CreatedSide(3, 1) });
  move.gluings.push_back({ CreatedSide(0, 1), CreatedSide(2, 0) });
  move.gluings.push_back({ CreatedSide(1, 2), CreatedSide(3, 2) });
  const auto insert = [&](const Side & side, std::size_t k, int i, std::size_t l, int j) {
    const Side mate = complex.GetMate(side);
    const bool isSame = GeneralComplex::AreGluable(
      move.created[k].vertices, i, complex.GetTetrahedron(side.tetrahedron).vertices, side.opposite);
    move.gluings.push_back({ CreatedSide(k, i), isSame ? side : mate, LineOf(complex, side) });
    move.gluings.push_back({ CreatedSide(l, j), isSame ? mate : side });
  };
  insert(first, 0, 3, 2, 3);
  insert(second, 1, 1, 3, 0);
  move.createdEdges = { Ascending(b, e), Ascending(c, e), Ascending(b, d) };
  return move;
}
} // namespace

MoveProposal
SplitEdge(const GeneralComplex & complex, const EdgeRing & ring, std::size_t i, std::size_t j)
{
  if (i == j)
  {
    return { MoveVerdict::SameTriangle, {} };
  }
  MoveProposal proposal = JoinEdges(complex, ring, i, ring, j);
  if (proposal)
  {
    const VertexPair ends = EndsOf(complex, ring);
    proposal.move.removedEdges.clear();
    proposal.move.createdEdges.push_back(Ascending(ends[0], ends[1]));
  }
  return proposal;
}

MoveProposal
JoinEdges(const GeneralComplex & complex, const EdgeRing & first, std::size_t i, const EdgeRing & second, std::size_t j)
{
  const VertexPair ends = EndsOf(complex, first);
  if (EndsOf(complex, second) != ends)
  {
    return { MoveVerdict::DifferentVertices, {} };
  }
  const TwoSides one = SidesOf(complex, first, i);
  const TwoSides two = SidesOf(complex, second, j);
  if (one.third == two.third)
  {
    return { MoveVerdict::JoinsVertexToItself, {} };
  }
  MoveProposal proposal;
  proposal.move = InsertDigon(complex, ends, one, two);
  proposal.move.removedEdges.push_back(Ascending(ends[0], ends[1]));
  return proposal;
}

MoveProposal
ReglueCrosswise(const GeneralComplex & complex, const Side & first, const Side & second)
{
  const Side firstMate = complex.GetMate(first);
  if (first == second || firstMate == second)
  {
    return { MoveVerdict::SameTriangle, {} };
  }
  const auto verticesOf = [&](const Side & side) { return complex.GetTetrahedron(side.tetrahedron).vertices; };
  const auto areGluable = [&](const Side & a, const Side & b) {
    return GeneralComplex::AreGluable(verticesOf(a), a.opposite, verticesOf(b), b.opposite);
  };
  // Either side of the second may be the one that faces as the first does.
  Side near = second;
  Side far = complex.GetMate(second);
  if (!areGluable(first, far))
  {
    std::swap(near, far);
  }
  if (!areGluable(first, far))
  {
    return { MoveVerdict::DifferentVertices, {} };
  }
  MoveProposal proposal;
  proposal.move.gluings.push_back({ first, far, LineOf(complex, first) });
  proposal.move.gluings.push_back({ near, firstMate, LineOf(complex, near) });
  return proposal;
}

MoveProposal
BridgeTriangles(const GeneralComplex & complex, const Side & first, const Side & second)
{
  const auto      verticesOf = [&](const Side & side) { return complex.GetTetrahedron(side.tetrahedron).vertices; };
  VertexQuadruple t = verticesOf(first);
  const VertexQuadruple   u = verticesOf(second);
  std::array<VertexId, 3> own{ { 0, 0, 0 } };   // a, b, c
  std::array<VertexId, 3> other{ { 0, 0, 0 } }; // a, d, e
  int                     common = 0;
  int                     ends = 1;
  int                     otherEnds = 1;
  for (int i = 0; i < 4; ++i)
  {
    const int  inSecond = LocalIndex(u, t[i]);
    const int  inFirst = LocalIndex(t, u[i]);
    const bool isCommon = i != first.opposite && inSecond >= 0 && inSecond != second.opposite;
    const bool isOtherCommon = i != second.opposite && inFirst >= 0 && inFirst != first.opposite;
    common += isCommon ? 1 : 0;
    if (common > 1)
    {
      return { MoveVerdict::DifferentVertices, {} };
    }
    if (i != first.opposite && (isCommon || ends < 3))
    {
      own[isCommon ? 0 : ends++] = t[i];
    }
    if (i != second.opposite && (isOtherCommon || otherEnds < 3))
    {
      other[isOtherCommon ? 0 : otherEnds++] = u[i];
    }
  }
  if (common != 1)
  {
    return { MoveVerdict::DifferentVertices, {} };
  }
  return { MoveVerdict::Legal, MakeBridge(complex, own, other, first, second) };
}

MoveProposal
CutAlongLoop(const GeneralComplex & complex, VertexId a, const std::vector<Side> & triangles,
             const std::vector<VertexId> & vertices)
{
  const std::size_t k = vertices.size();
  if (k == 2)
  {
    return ReglueCrosswise(complex, triangles[0], triangles[1]);
  }
  const VertexId b = vertices[0];
  if (std::count(vertices.begin(), vertices.end(), b) > 1)
  {
    return { MoveVerdict::JoinsVertexToItself, {} };
  }
  MoveProposal  proposal;
  GeneralMove & move = proposal.move;
  // Front tetrahedra have even numbers, their mirror images odd ones.
  for (std::size_t i = 1; i + 1 < k; ++i)
  {
    move.created.push_back({ { { a, b, vertices[i], vertices[i + 1] } } });
    move.created.push_back({ { { b, a, vertices[i], vertices[i + 1] } } });
    const std::size_t front = move.created.size() - 2;
    move.gluings.push_back({ CreatedSide(front, 0), CreatedSide(front + 1, 1) });
    if (i > 1)
    {
      move.gluings.push_back({ CreatedSide(front - 2, 2), CreatedSide(front, 3) });
      move.gluings.push_back({ CreatedSide(front - 1, 2), CreatedSide(front + 1, 3) });
      move.createdEdges.push_back(Ascending(b, vertices[i]));
    }
  }
  const auto insert = [&](const Side & side, std::size_t front, int i, int j) {
    const Side mate = complex.GetMate(side);
    const bool isSame = GeneralComplex::AreGluable(
      move.created[front].vertices, i, complex.GetTetrahedron(side.tetrahedron).vertices, side.opposite);
    move.gluings.push_back({ CreatedSide(front, i), isSame ? side : mate, LineOf(complex, side) });
    move.gluings.push_back({ CreatedSide(front + 1, j), isSame ? mate : side });
  };
  insert(triangles[0], 0, 3, 3);
  insert(triangles[k - 1], move.created.size() - 2, 2, 2);
  for (std::size_t i = 1; i + 1 < k; ++i)
  {
    insert(triangles[i], 2 * (i - 1), 1, 0);
  }
  for (const VertexId v : vertices)
  {
    move.createdEdges.push_back(Ascending(a, v));
  }
  return proposal;
}

MoveProposal
InsertPillow(const GeneralComplex & complex, const Side & triangle, VertexId vertex)
{
  const VertexQuadruple & t = complex.GetTetrahedron(triangle.tetrahedron).vertices;
  const int               at = triangle.opposite;
  VertexQuadruple         near = t;
  near[at] = vertex;
  for (int i = 0; i < 4; ++i)
  {
    if (i != at && t[i] == vertex)
    {
      return { MoveVerdict::JoinsVertexToItself, {} };
    }
  }
  // The mirror image of the tetrahedron lies behind its triangle, its own image before that of the other side.
  VertexQuadruple far = near;
  const int       i = (at + 1) % 4;
  const int       j = (at + 2) % 4;
  std::swap(far[i], far[j]);
  MoveProposal  proposal;
  GeneralMove & move = proposal.move;
  move.created.push_back({ far });
  move.created.push_back({ near });
  move.gluings.push_back({ CreatedSide(0, at), triangle, LineOf(complex, triangle) });
  move.gluings.push_back({ CreatedSide(1, at), complex.GetMate(triangle) });
  for (int k = 0; k < 4; ++k)
  {
    if (k != at)
    {
      move.gluings.push_back({ CreatedSide(1, k), CreatedSide(0, k == i ? j : k == j ? i : k) });
      move.createdEdges.push_back(Ascending(vertex, t[k]));
    }
  }
  return proposal;
}
} // namespace tissue
