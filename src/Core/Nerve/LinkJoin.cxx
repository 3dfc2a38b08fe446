/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/LinkJoin.h"

#include <algorithm>
#include <deque>
#include <map>

namespace tissue
{
namespace
{
/** Edges of a link surface, by the vertices at their ends. */
std::multimap<VertexId, LocalEdge>
EdgesByEnd(const GeneralComplex & complex, const LinkSurface & surface)
{
  std::multimap<VertexId, LocalEdge> edges;
  for (const LocalEdge & edge : surface.GetEdges())
  {
    edges.emplace(complex.GetTetrahedron(edge.tetrahedron).vertices[edge.to], edge);
  }
  return edges;
}

/** Places of one move that are judged at most: a cell of many walls to the exterior has more than are worth the time,
 * and the best of these is hardly worse. */
constexpr int MaximumNumberOfProposals = 2000;
} // namespace

LinkJoin::LinkJoin(GeneralComplex & complex, const VertexLinks & links, const TissuePlaces & places)
  : m_Complex(complex)
  , m_Links(links)
  , m_Energy(places, PlacePreferences::WallsFirst(), complex)
  , m_LinkOf(links.linkOf)
  , m_Sets(links.links.size())
{}

std::vector<std::int64_t>
LinkJoin::RootsOf(VertexId v)
{
  std::vector<std::int64_t> roots;
  for (std::size_t i = m_Links.firstOfVertex[v]; i < m_Links.firstOfVertex[v + 1]; ++i)
  {
    if (m_Sets.Find(static_cast<std::int64_t>(i)) == static_cast<std::int64_t>(i))
    {
      roots.push_back(static_cast<std::int64_t>(i));
    }
  }
  return roots;
}

NerveRepairRecord
LinkJoin::Step(VertexId v)
{
  m_Surfaces.clear();
  for (const std::int64_t root : this->RootsOf(v))
  {
    // Moves of the repair take no tetrahedron out, so the first ones are there still.
    const TetrahedronId first = m_Links.links[static_cast<std::size_t>(root)].first;
    m_Surfaces.emplace_back(m_Complex, Side{ first, LocalIndex(m_Complex.GetTetrahedron(first).vertices, v) });
  }
  std::stable_sort(m_Surfaces.begin(), m_Surfaces.end(), [](const LinkSurface & a, const LinkSurface & b) {
    return a.GetTriangles().size() > b.GetTriangles().size();
  });
  m_Best.clear();
  m_NumberOfProposals = 0;
  const RepairKind kind = this->JoinAtEdges(true)    ? RepairKind::JoinedAtExterior
                          : this->JoinAtEdges(false) ? RepairKind::JoinedAtCell
                          : this->GlueCrosswise(v)   ? RepairKind::GluedCrosswise
                          : this->MakeDigon(v)       ? RepairKind::FalseDigon
                          : this->Bridge(v)          ? RepairKind::Bridged
                                                     : RepairKind::NotRepaired;
  return { kind, v, m_Best.empty() ? v : m_Best.front().partner };
}

void
LinkJoin::Consider(const MoveProposal & proposal, double cost, VertexId partner)
{
  if (proposal && (m_Best.empty() || cost < m_Best.front().cost))
  {
    m_Best.assign(1, { proposal.move, cost, partner });
  }
}

void
LinkJoin::Meet(const Side & a, const Side & b)
{
  const VertexQuadruple & t = m_Complex.GetTetrahedron(a.tetrahedron).vertices;
  for (int i = 0; i < 4; ++i)
  {
    if (i == a.opposite)
    {
      continue;
    }
    const auto     j = static_cast<std::size_t>(LocalIndex(m_Complex.GetTetrahedron(b.tetrahedron).vertices, t[i]));
    std::int32_t & here = m_LinkOf[static_cast<std::size_t>(a.tetrahedron)][static_cast<std::size_t>(i)];
    std::int32_t & there = m_LinkOf[static_cast<std::size_t>(b.tetrahedron)][j];
    if (here >= 0 && there >= 0)
    {
      m_Sets.Unite(here, there);
    }
    here = here < 0 ? there : here;
    there = there < 0 ? here : there;
  }
}

bool
LinkJoin::Carry()
{
  if (m_Best.empty())
  {
    return false;
  }
  const GeneralMove & move = m_Best.front().move;
  m_Energy.Account(m_Complex, move);
  const GeneralMove inverse = m_Complex.Apply(move);
  m_LinkOf.resize(static_cast<std::size_t>(m_Complex.TetrahedronIdBound()), { { -1, -1, -1, -1 } });
  for (const TetrahedronId id : inverse.removed)
  {
    m_LinkOf[static_cast<std::size_t>(id)].fill(-1);
  }
  // Twice, as a created one may be glued to another that has not heard of a link yet.
  for (int round = 0; round < 2; ++round)
  {
    for (const TetrahedronId id : inverse.removed)
    {
      for (int i = 0; i < 4; ++i)
      {
        this->Meet({ id, i }, m_Complex.GetMate({ id, i }));
      }
    }
    for (const GeneralMove::Gluing & gluing : move.gluings)
    {
      if (!GeneralMove::IsCreated(gluing.a.tetrahedron) && !GeneralMove::IsCreated(gluing.b.tetrahedron))
      {
        this->Meet(gluing.a, gluing.b);
      }
    }
  }
  return true;
}

void
LinkJoin::ConsiderJoin(const LocalEdge & first, const LocalEdge & second, VertexId partner)
{
  const EdgeRing one = m_Complex.GetRing(first);
  const EdgeRing two = m_Complex.GetRing(second);
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    for (std::size_t j = 0; j < two.size(); ++j)
    {
      const MoveProposal proposal = JoinEdges(m_Complex, one, i, two, j);
      if (proposal && m_NumberOfProposals < MaximumNumberOfProposals)
      {
        ++m_NumberOfProposals;
        this->Consider(proposal, m_Energy.Difference(m_Complex, proposal.move), partner);
      }
    }
  }
}

bool
LinkJoin::JoinAtEdges(bool isExterior)
{
  const auto edges = EdgesByEnd(m_Complex, m_Surfaces[0]);
  for (std::size_t s = 1; s < m_Surfaces.size(); ++s)
  {
    for (const LocalEdge & second : m_Surfaces[s].GetEdges())
    {
      const VertexId partner = this->EndOf(second);
      if (m_Complex.IsOutside(partner) != isExterior)
      {
        continue;
      }
      const auto range = edges.equal_range(partner);
      for (auto it = range.first; it != range.second && m_NumberOfProposals < MaximumNumberOfProposals; ++it)
      {
        // Within one link of a cell this would make a handle of it.
        if (isExterior || this->LinkAtEnd(it->second) != this->LinkAtEnd(second))
        {
          this->ConsiderJoin(it->second, second, partner);
        }
      }
    }
  }
  return this->Carry();
}

bool
LinkJoin::GlueCrosswise(VertexId v)
{
  // Around an edge opposite to the cell the cell occurs with both of its links.
  for (const Side & side : m_Surfaces[0].GetTriangles())
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        if (i == side.opposite || j == side.opposite)
        {
          continue;
        }
        const EdgeRing ring = m_Complex.GetRing({ side.tetrahedron, i, j });
        const Side     first{ side.tetrahedron, 6 - i - j - side.opposite };
        for (const RingStep & step : ring)
        {
          const VertexQuadruple & t = m_Complex.GetTetrahedron(step.tetrahedron).vertices;
          if (t[step.here] == v &&
              this->LinkOf(step.tetrahedron, step.here) != this->LinkOf(side.tetrahedron, side.opposite))
          {
            this->Consider(ReglueCrosswise(m_Complex, first, { step.tetrahedron, step.next }),
                           m_Energy.CostOfEdge(t[step.from], t[step.to]),
                           t[step.from]);
          }
        }
      }
    }
  }
  return this->Carry();
}

LinkJoin::Path
LinkJoin::FindPath(VertexId v, std::int64_t own, const LinkSurface & surface)
{
  const auto &              edges = surface.GetEdges();
  std::vector<std::int32_t> before(edges.size(), -1);
  std::deque<std::int32_t>  open;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    if (this->EndOf(edges[e]) == v && this->LinkAtEnd(edges[e]) == own)
    {
      before[e] = static_cast<std::int32_t>(e);
      open.push_back(static_cast<std::int32_t>(e));
    }
  }
  while (!open.empty())
  {
    const std::int32_t e = open.front();
    const LocalEdge &  edge = edges[static_cast<std::size_t>(e)];
    open.pop_front();
    if (this->EndOf(edge) == v && this->LinkAtEnd(edge) != own)
    {
      Path path{ edge };
      for (std::int32_t at = e; before[static_cast<std::size_t>(at)] != at;)
      {
        at = before[static_cast<std::size_t>(at)];
        path.insert(path.begin(), edges[static_cast<std::size_t>(at)]);
      }
      return path;
    }
    for (const RingStep & step : m_Complex.GetRing(edge))
    {
      const std::int32_t next = surface.FindEdge(step.tetrahedron, step.here);
      if (before[static_cast<std::size_t>(next)] < 0)
      {
        before[static_cast<std::size_t>(next)] = e;
        open.push_back(next);
      }
    }
  }
  return {};
}

bool
LinkJoin::MakeDigon(VertexId v)
{
  const Side &              start = m_Surfaces[0].GetTriangles()[0];
  const std::int64_t        own = this->LinkOf(start.tetrahedron, start.opposite);
  std::vector<std::int64_t> seen;
  Path                      shortest;
  for (const LocalEdge & toNeighbor : m_Surfaces[0].GetEdges())
  {
    const std::int64_t link = this->LinkAtEnd(toNeighbor);
    if (std::find(seen.begin(), seen.end(), link) == seen.end())
    {
      seen.push_back(link);
      const Path path = this->FindPath(v, own, LinkSurface(m_Complex, { toNeighbor.tetrahedron, toNeighbor.to }));
      if (!path.empty() && (shortest.empty() || path.size() < shortest.size()))
      {
        shortest = path;
      }
    }
  }
  if (shortest.size() < 4)
  {
    return false;
  }
  // The edge to the path's second vertex is split, and a wall made from its first one, the cell, to its third.
  const EdgeRing    ring = m_Complex.GetRing(shortest[1]);
  const LinkSurface surface(m_Complex, { shortest[1].tetrahedron, shortest[1].from });
  const auto        positionOf = [&](const LocalEdge & edge) {
    const std::int32_t index = surface.FindEdge(edge.tetrahedron, edge.to);
    std::size_t        i = 0;
    while (surface.FindEdge(ring[i].tetrahedron, ring[i].here) != index)
    {
      ++i;
    }
    return i;
  };
  const VertexId partner = m_Complex.GetTetrahedron(shortest[1].tetrahedron).vertices[shortest[1].from];
  this->Consider(SplitEdge(m_Complex, ring, positionOf(shortest[0]), positionOf(shortest[2])), 0.0, partner);
  return this->Carry();
}

bool
LinkJoin::Bridge(VertexId v)
{
  for (const Side & first : m_Surfaces[0].GetTriangles())
  {
    for (const Side & second : m_Surfaces[1].GetTriangles())
    {
      for (int i = 0; i < 4; ++i)
      {
        if (i != first.opposite && m_Best.empty())
        {
          const MoveProposal proposal =
            BridgeTriangles(m_Complex, { first.tetrahedron, i }, { second.tetrahedron, second.opposite == 0 ? 1 : 0 });
          this->Consider(proposal, 0.0, v);
        }
      }
    }
  }
  return this->Carry();
}
} // namespace tissue
