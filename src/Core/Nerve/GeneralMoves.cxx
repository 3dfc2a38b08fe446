/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/GeneralMoves.h"

#include "Nerve/MoveParts.h"

#include <algorithm>
#include <map>

namespace tissue
{
namespace
{
/** A triangle of the boundary of what a move removes, and that of what it creates in the same place. */
struct Slot
{
  Side before;
  Side after;
};

/** Glues what is created to what is outside. The removed tetrahedra may be glued to each other at their boundary: then
 * the created ones are, in the same places. */
void
GlueBoundary(const GeneralComplex & complex, const GeneralMove::List<Slot> & slots, GeneralMove & move)
{
  for (std::size_t i = 0; i < slots.size(); ++i)
  {
    const Side   mate = complex.GetMate(slots[i].before);
    const auto   at = std::find_if(slots.begin(), slots.end(), [&](const Slot & s) { return s.before == mate; });
    const LineId line = LineOf(complex, slots[i].before);
    if (at == slots.end())
    {
      move.gluings.push_back({ slots[i].after, mate, line });
    }
    else if (static_cast<std::size_t>(at - slots.begin()) > i)
    {
      move.gluings.push_back({ slots[i].after, at->after, line });
    }
  }
}

/** The created tetrahedra over a triangulation of a ring, and the gluings among them. */
class RingFilling
{
public:
  RingFilling(VertexPair ends, const boost::container::small_vector<VertexId, 12> & ring,
              const RingTriangulation & triangles, GeneralMove & move)
    : m_N(static_cast<int>(ring.size()))
    , m_Ring(ring)
    , m_Open(ring.size() * ring.size())
    , m_Move(move)
  {
    for (const auto & [i, j, k] : triangles)
    {
      const std::size_t upper = move.created.size();
      move.created.push_back({ { { ends[0], ring[i], ring[j], ring[k] } } });
      move.created.push_back({ { { ends[1], ring[i], ring[k], ring[j] } } });
      move.gluings.push_back({ CreatedSide(upper, 0), CreatedSide(upper + 1, 0) });
      this->Meet(i, j, { CreatedSide(upper, 3), CreatedSide(upper + 1, 2) });
      this->Meet(j, k, { CreatedSide(upper, 1), CreatedSide(upper + 1, 1) });
      this->Meet(i, k, { CreatedSide(upper, 2), CreatedSide(upper + 1, 3) });
    }
  }

  /** Those at the side of the ring from its vertex i to the next: at the edge's `from`, at its `to`. */
  const std::array<Side, 2> &
  At(int i) const
  {
    return i + 1 < m_N ? m_Open[i * m_N + i + 1] : m_Open[m_N - 1];
  }

private:
  /** The second triangle at a diagonal is glued to the first; a side of the ring has one alone. */
  void
  Meet(int i, int k, const std::array<Side, 2> & sides)
  {
    std::array<Side, 2> & open = m_Open[i * m_N + k];
    if (open[0].tetrahedron == Side().tetrahedron)
    {
      open = sides;
      return;
    }
    m_Move.gluings.push_back({ open[0], sides[0] });
    m_Move.gluings.push_back({ open[1], sides[1] });
    m_Move.createdEdges.push_back(Ascending(m_Ring[i], m_Ring[k]));
  }

  int                                                  m_N;
  const boost::container::small_vector<VertexId, 12> & m_Ring;
  GeneralMove::List<std::array<Side, 2>>               m_Open;
  GeneralMove &                                        m_Move;
};

bool
JoinsEqual(const boost::container::small_vector<VertexId, 12> & ring, const RingTriangulation & triangles)
{
  return std::any_of(triangles.begin(), triangles.end(), [&](const std::array<int, 3> & t) {
    return ring[t[0]] == ring[t[1]] || ring[t[1]] == ring[t[2]] || ring[t[0]] == ring[t[2]];
  });
}
} // namespace

const char *
ToString(MoveVerdict verdict)
{
  switch (verdict)
  {
    case MoveVerdict::Legal:
      return "legal";
    case MoveVerdict::JoinsVertexToItself:
      return "a new edge would join a vertex to itself";
    case MoveVerdict::NoTriangulation:
      return "the ring has no triangulation that is allowed";
    case MoveVerdict::WrongDegree:
      return "the edge has not as many tetrahedra around it as the move is for";
    case MoveVerdict::SameEdge:
      return "the two edges to be merged are one";
    case MoveVerdict::SameTriangle:
      return "the two triangles to be opened are one";
    case MoveVerdict::DifferentVertices:
      return "the two triangles have not the vertices in common that the move is for";
  }
  return "unknown";
}

MoveProposal
SwapTriangle(const GeneralComplex & complex, const Side & triangle)
{
  const Side              mate = complex.GetMate(triangle);
  const VertexQuadruple & t = complex.GetTetrahedron(triangle.tetrahedron).vertices;
  const VertexQuadruple & u = complex.GetTetrahedron(mate.tetrahedron).vertices;
  const VertexId          a = t[triangle.opposite];
  const VertexId          b = u[mate.opposite];
  if (a == b)
  {
    return { MoveVerdict::JoinsVertexToItself, {} };
  }
  // (a, x, y, z) is positive for the local vertices x, y, z of the triangle.
  const int                first = triangle.opposite == 0 ? 1 : 0;
  const std::array<int, 2> others = EvenComplement(triangle.opposite, first);
  const std::array<int, 3> local{ { first, others[0], others[1] } };
  MoveProposal             proposal;
  GeneralMove &            move = proposal.move;
  GeneralMove::List<Slot>  slots;
  move.removed = { triangle.tetrahedron, mate.tetrahedron };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const int      behind = local[(k + 2) % 3];
    const VertexId x = t[local[k]];
    const VertexId y = t[local[(k + 1) % 3]];
    move.created.push_back({ { { a, b, x, y } } });
    move.gluings.push_back({ CreatedSide(k, 2), CreatedSide((k + 1) % 3, 3) });
    slots.push_back({ { triangle.tetrahedron, behind }, CreatedSide(k, 1) });
    slots.push_back({ { mate.tetrahedron, LocalIndex(u, t[behind]) }, CreatedSide(k, 0) });
  }
  GlueBoundary(complex, slots, move);
  move.createdEdges.push_back(Ascending(a, b));
  return proposal;
}

MoveProposal
RemoveEdge(const GeneralComplex & complex, const LocalEdge & edge, const RingTriangulation & triangles)
{
  const EdgeRing ring = complex.GetRing(edge);
  const auto     vertices = complex.GetRingVertices(ring);
  if (ring.size() < 3)
  {
    return { MoveVerdict::WrongDegree, {} };
  }
  if (triangles.empty())
  {
    return { MoveVerdict::NoTriangulation, {} };
  }
  if (JoinsEqual(vertices, triangles))
  {
    return { MoveVerdict::JoinsVertexToItself, {} };
  }
  MoveProposal     proposal;
  GeneralMove &    move = proposal.move;
  const VertexPair ends = EndsOf(complex, ring);
  move.removedEdges.push_back(Ascending(ends[0], ends[1]));
  const RingFilling       filling(ends, vertices, triangles, move);
  GeneralMove::List<Slot> slots;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const auto & sides = filling.At(static_cast<int>(i));
    move.removed.push_back(ring[i].tetrahedron);
    slots.push_back({ { ring[i].tetrahedron, ring[i].to }, sides[0] });
    slots.push_back({ { ring[i].tetrahedron, ring[i].from }, sides[1] });
  }
  GlueBoundary(complex, slots, move);
  return proposal;
}

MoveProposal
CloseEdge(const GeneralComplex & complex, const LocalEdge & edge)
{
  const EdgeRing ring = complex.GetRing(edge);
  if (ring.size() != 2)
  {
    return { MoveVerdict::WrongDegree, {} };
  }
  const RingStep & one = ring[0];
  const RingStep & two = ring[1];
  const EdgeRing   opposite = complex.GetRing({ one.tetrahedron, one.here, one.next });
  if (std::any_of(
        opposite.begin(), opposite.end(), [&](const RingStep & step) { return step.tetrahedron == two.tetrahedron; }))
  {
    return { MoveVerdict::SameEdge, {} };
  }
  MoveProposal  proposal;
  GeneralMove & move = proposal.move;
  move.removed = { one.tetrahedron, two.tetrahedron };
  for (const auto & [i, j] : { std::pair(one.from, two.from), std::pair(one.to, two.to) })
  {
    const Side   first{ one.tetrahedron, i };
    const Side   second{ two.tetrahedron, j };
    const LineId line = LineOf(complex, first);
    move.gluings.push_back(
      { complex.GetMate(first), complex.GetMate(second), line == NoPlace ? LineOf(complex, second) : line });
  }
  const VertexPair        ends = EndsOf(complex, ring);
  const VertexQuadruple & t = complex.GetTetrahedron(one.tetrahedron).vertices;
  move.removedEdges.push_back(Ascending(ends[0], ends[1]));
  move.removedEdges.push_back(Ascending(t[one.here], t[one.next]));
  return proposal;
}

bool
KeepsTopology(const GeneralComplex & complex, const GeneralMove & move, const std::vector<VertexId> & cellOf)
{
  if (cellOf.empty())
  {
    return true;
  }
  // Twice the Euler characteristic of what each cell's vertices span: every tetrahedron has half of its triangles.
  std::map<VertexId, int> change;
  const auto              addTetrahedron = [&](const VertexQuadruple & vertices, int sign) {
    std::map<VertexId, int> count;
    for (const VertexId v : vertices)
    {
      ++count[cellOf[v]];
    }
    for (const auto & [cell, n] : count)
    {
      change[cell] += sign * std::max(n - 2, 0);
    }
  };
  const auto addEdge = [&](const VertexPair & ends, int sign) {
    if (cellOf[ends[0]] == cellOf[ends[1]])
    {
      change[cellOf[ends[0]]] -= 2 * sign;
    }
  };
  for (const TetrahedronId id : move.removed)
  {
    addTetrahedron(complex.GetTetrahedron(id).vertices, -1);
  }
  for (const GeneralMove::NewTetrahedron & created : move.created)
  {
    addTetrahedron(created.vertices, 1);
  }
  for (const VertexPair & edge : move.removedEdges)
  {
    addEdge(edge, -1);
  }
  for (const VertexPair & edge : move.createdEdges)
  {
    addEdge(edge, 1);
  }
  return std::all_of(change.begin(), change.end(), [](const auto & entry) { return entry.second == 0; });
}
} // namespace tissue
