/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/GeneralMove.h"

#include <algorithm>
#include <stdexcept>

namespace tissue
{
bool
IsEven(const std::array<int, 4> & p)
{
  int inversions = 0;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      inversions += p[i] > p[j] ? 1 : 0;
    }
  }
  return inversions % 2 == 0;
}

std::array<int, 2>
EvenComplement(int i, int j)
{
  std::array<int, 2> others{ { 0, 0 } };
  int                count = 0;
  for (int k = 0; k < 4; ++k)
  {
    if (k != i && k != j)
    {
      others[count++] = k;
    }
  }
  if (!IsEven({ { i, j, others[0], others[1] } }))
  {
    std::swap(others[0], others[1]);
  }
  return others;
}

bool
GeneralComplex::AreGluable(const VertexQuadruple & a, int i, const VertexQuadruple & b, int j)
{
  std::array<int, 4> inB{ { 0, 0, 0, 0 } };
  for (int k = 0; k < 4; ++k)
  {
    inB[k] = k == i ? j : LocalIndex(b, a[k]);
    if (inB[k] < 0 || (k != i && inB[k] == j))
    {
      return false;
    }
  }
  // With the one vertex in the place of the other the two tetrahedra are mirror images.
  return !IsEven(inB);
}

Side
GeneralComplex::GetMate(const Side & side) const
{
  const Tetrahedron & t = m_Tetrahedra[side.tetrahedron];
  const TetrahedronId neighbor = t.neighbors[side.opposite];
  const Tetrahedron & other = m_Tetrahedra[neighbor];
  for (int j = 0; j < 4; ++j)
  {
    const int k = LocalIndex(t.vertices, other.vertices[j]);
    if (k < 0 || k == side.opposite)
    {
      return { neighbor, j };
    }
  }
  throw std::logic_error("A tetrahedron is glued to one that has not the vertices of the triangle.");
}

EdgeRing
GeneralComplex::GetRing(const LocalEdge & edge) const
{
  const Tetrahedron &      start = m_Tetrahedra[edge.tetrahedron];
  const VertexId           u = start.vertices[edge.from];
  const VertexId           v = start.vertices[edge.to];
  const std::array<int, 2> others = EvenComplement(edge.from, edge.to);
  EdgeRing                 ring;
  RingStep                 step{ edge.tetrahedron, edge.from, edge.to, others[0], others[1] };
  do
  {
    ring.push_back(step);
    const VertexId      next = m_Tetrahedra[step.tetrahedron].vertices[step.next];
    const Side          mate = this->GetMate({ step.tetrahedron, step.here });
    const Tetrahedron & t = m_Tetrahedra[mate.tetrahedron];
    step = { mate.tetrahedron,
             LocalIndex(t.vertices, u),
             LocalIndex(t.vertices, v),
             LocalIndex(t.vertices, next),
             mate.opposite };
  } while (step.tetrahedron != edge.tetrahedron);
  return ring;
}

boost::container::small_vector<VertexId, 12>
GeneralComplex::GetRingVertices(const EdgeRing & ring) const
{
  boost::container::small_vector<VertexId, 12> vertices;
  for (const RingStep & step : ring)
  {
    vertices.push_back(m_Tetrahedra[step.tetrahedron].vertices[step.here]);
  }
  return vertices;
}

std::vector<GeneralComplex::Edge>
GeneralComplex::FindEdges() const
{
  std::vector<Edge>          edges;
  std::vector<std::uint16_t> isFound(m_Tetrahedra.size(), 0); // a bit for each pair of local vertices
  const auto                 bit = [](int i, int j) { return 1u << (4 * std::min(i, j) + std::max(i, j)); };
  for (TetrahedronId id = 0; id < this->TetrahedronIdBound(); ++id)
  {
    for (int i = 0; this->IsAlive(id) && i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        if (isFound[id] & bit(i, j))
        {
          continue;
        }
        const EdgeRing ring = this->GetRing({ id, i, j });
        for (const RingStep & step : ring)
        {
          isFound[step.tetrahedron] = static_cast<std::uint16_t>(isFound[step.tetrahedron] | bit(step.from, step.to));
        }
        const VertexQuadruple & t = m_Tetrahedra[id].vertices;
        const bool              isAscending = t[i] < t[j];
        const LocalEdge         local = isAscending ? LocalEdge{ id, i, j } : LocalEdge{ id, j, i };
        edges.push_back(
          { { { std::min(t[i], t[j]), std::max(t[i], t[j]) } }, static_cast<std::int32_t>(ring.size()), local });
      }
    }
  }
  return edges;
}

GeneralComplex
GeneralComplex::InOrder(const std::vector<TetrahedronId> & order) const
{
  std::vector<TetrahedronId> idOf(m_Tetrahedra.size(), Unglued);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    idOf[order[i]] = static_cast<TetrahedronId>(i);
  }
  GeneralComplex ordered(m_NumberOfVertices);
  ordered.Reserve(order.size());
  for (const TetrahedronId id : order)
  {
    ordered.m_Tetrahedra.push_back(m_Tetrahedra[id]);
    for (TetrahedronId & neighbor : ordered.m_Tetrahedra.back().neighbors)
    {
      neighbor = neighbor >= 0 ? idOf[neighbor] : neighbor;
    }
  }
  return ordered;
}

TetrahedronId
GeneralComplex::Allocate()
{
  if (m_Free.empty())
  {
    m_Tetrahedra.emplace_back();
    return static_cast<TetrahedronId>(m_Tetrahedra.size()) - 1;
  }
  const TetrahedronId id = m_Free.back();
  m_Free.pop_back();
  return id;
}

TetrahedronId
GeneralComplex::Add(const VertexQuadruple & vertices, CornerId corner)
{
  for (int i = 0; i < 4; ++i)
  {
    if (vertices[i] < 0 || vertices[i] >= m_NumberOfVertices || LocalIndex(vertices, vertices[i]) != i)
    {
      throw std::invalid_argument("A tetrahedron needs four different vertices of the complex.");
    }
  }
  const TetrahedronId id = this->Allocate();
  Tetrahedron &       t = m_Tetrahedra[id];
  t.vertices = vertices;
  t.neighbors.fill(Unglued);
  t.lines.fill(NoPlace);
  t.corner = corner;
  return id;
}

void
GeneralComplex::Glue(const Side & a, const Side & b, LineId line)
{
  Tetrahedron & first = m_Tetrahedra[a.tetrahedron];
  Tetrahedron & second = m_Tetrahedra[b.tetrahedron];
  if (!AreGluable(first.vertices, a.opposite, second.vertices, b.opposite))
  {
    throw std::invalid_argument("Two triangles to be glued have different vertices or the same orientation.");
  }
  first.neighbors[a.opposite] = b.tetrahedron;
  second.neighbors[b.opposite] = a.tetrahedron;
  first.lines[a.opposite] = line;
  second.lines[b.opposite] = line;
}

void
GeneralComplex::Remove(const std::vector<TetrahedronId> & ids)
{
  for (const TetrahedronId id : ids)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (m_Tetrahedra[id].neighbors[i] >= 0)
      {
        const Side mate = this->GetMate({ id, i });
        m_Tetrahedra[mate.tetrahedron].neighbors[mate.opposite] = Unglued;
      }
    }
    m_Tetrahedra[id].neighbors.fill(Dead);
    m_Free.push_back(id);
  }
}

void
GeneralComplex::CheckMove(const GeneralMove & move) const
{
  const auto isKept = [&](TetrahedronId id) {
    return id >= 0 && id < this->TetrahedronIdBound() && this->IsAlive(id) &&
           std::count(move.removed.begin(), move.removed.end(), id) == 0;
  };
  const auto verticesOf = [&](TetrahedronId name) -> const VertexQuadruple & {
    if (GeneralMove::IsCreated(name) ? GeneralMove::IndexOfCreated(name) >= move.created.size() : !isKept(name))
    {
      throw std::logic_error("A move glues a tetrahedron that does not exist.");
    }
    return GeneralMove::IsCreated(name) ? move.created[GeneralMove::IndexOfCreated(name)].vertices
                                        : m_Tetrahedra[name].vertices;
  };
  for (const TetrahedronId id : move.removed)
  {
    if (id < 0 || id >= this->TetrahedronIdBound() || !this->IsAlive(id))
    {
      throw std::logic_error("A move removes a tetrahedron that does not exist.");
    }
  }
  for (const GeneralMove::Gluing & gluing : move.gluings)
  {
    if (!AreGluable(
          verticesOf(gluing.a.tetrahedron), gluing.a.opposite, verticesOf(gluing.b.tetrahedron), gluing.b.opposite))
    {
      throw std::logic_error("A move glues two triangles that do not match.");
    }
  }
}

GeneralMove
GeneralComplex::InverseOf(const GeneralMove & move) const
{
  GeneralMove inverse;
  inverse.removedEdges = move.createdEdges;
  inverse.createdEdges = move.removedEdges;
  // Every triangle that is open in between is named once: by the first of its two sides that is met.
  GeneralMove::List<Side> named;
  const auto              nameOf = [&](const Side & side) {
    const auto at = std::find(move.removed.begin(), move.removed.end(), side.tetrahedron);
    return at == move.removed.end()
                          ? side
                          : Side{ GeneralMove::Created(static_cast<std::size_t>(at - move.removed.begin())), side.opposite };
  };
  const auto restore = [&](const Side & side) {
    if (std::find(named.begin(), named.end(), side) == named.end())
    {
      const Side mate = this->GetMate(side);
      named.push_back(mate);
      inverse.gluings.push_back({ nameOf(side), nameOf(mate), m_Tetrahedra[side.tetrahedron].lines[side.opposite] });
    }
  };
  for (const TetrahedronId id : move.removed)
  {
    inverse.created.push_back({ m_Tetrahedra[id].vertices, m_Tetrahedra[id].corner });
    for (int i = 0; i < 4; ++i)
    {
      restore({ id, i });
    }
  }
  for (const GeneralMove::Gluing & gluing : move.gluings)
  {
    for (const Side & side : { gluing.a, gluing.b })
    {
      if (!GeneralMove::IsCreated(side.tetrahedron))
      {
        const Side mate = this->GetMate(side);
        if (nameOf(mate).tetrahedron >= 0)
        {
          restore(side);
          named.push_back(side);
        }
      }
    }
  }
  return inverse;
}

GeneralMove
GeneralComplex::Apply(const GeneralMove & move)
{
  this->CheckMove(move);
  GeneralMove inverse = this->InverseOf(move);
  // The created ones take the ids of the removed ones in their order, then free ones from the top of the stack; ids
  // left over go there the other way round. So the inverse finds each id where it was.
  GeneralMove::List<TetrahedronId> ids(move.removed.begin(), move.removed.end());
  while (ids.size() > move.created.size())
  {
    m_Tetrahedra[ids.back()].neighbors.fill(Dead);
    m_Free.push_back(ids.back());
    ids.pop_back();
  }
  while (ids.size() < move.created.size())
  {
    ids.push_back(this->Allocate());
  }
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    m_Tetrahedra[ids[k]] = Tetrahedron{ move.created[k].vertices, {}, {}, move.created[k].corner };
    m_Tetrahedra[ids[k]].neighbors.fill(Unglued);
  }
  inverse.removed.assign(ids.begin(), ids.end());
  const auto here = [&](const Side & side) {
    return GeneralMove::IsCreated(side.tetrahedron)
             ? Side{ ids[GeneralMove::IndexOfCreated(side.tetrahedron)], side.opposite }
             : side;
  };
  for (const GeneralMove::Gluing & gluing : move.gluings)
  {
    this->Glue(here(gluing.a), here(gluing.b), gluing.line);
  }
  return inverse;
}
} // namespace tissue
