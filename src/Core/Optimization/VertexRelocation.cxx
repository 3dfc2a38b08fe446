/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Optimization/VertexRelocation.h"

#include "Common/Algorithms.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace tissue
{
namespace
{
/** The replacements since the start of an attempt, by whose inverses it can be undone. */
class Journal
{
public:
  explicit Journal(AnnealingState & state)
    : m_State(state)
    , m_BestEnergy(state.energy.Total())
  {}

  void
  Do(const Replacement & replacement)
  {
    m_Inverses.push_back(m_State.Do(replacement));
  }

  /** Does the same as AnnealingState::Try(), and remembers where the energy was least. */
  void
  Try(const Proposal & proposal, double temperature)
  {
    if (!proposal || !m_State.Accepts(proposal, temperature))
    {
      return;
    }
    this->Do(proposal.replacement);
    if (m_State.energy.Total() < m_BestEnergy)
    {
      m_BestEnergy = m_State.energy.Total();
      m_Best = m_Inverses.size();
    }
  }

  /** Undoes all that came after the given number of replacements. */
  void
  UndoTo(std::size_t size)
  {
    while (m_Inverses.size() > size)
    {
      m_State.Do(m_Inverses.back());
      m_Inverses.pop_back();
    }
  }

  std::size_t
  Size() const
  {
    return m_Inverses.size();
  }

  /** Returns the number of replacements up to the state of least energy, which is 0 if that was the start. */
  std::size_t
  Best() const
  {
    return m_Best;
  }

private:
  AnnealingState &         m_State;
  std::vector<Replacement> m_Inverses;
  double                   m_BestEnergy;
  std::size_t              m_Best = 0;
};
/** Takes one vertex at a time out of the complex, and puts it in at a better place if it finds one. */
class Relocation
{
public:
  Relocation(AnnealingState & state, const VertexRelocationParameters & parameters, double oneQuadruple)
    : m_State(state)
    , m_Parameters(parameters)
    , m_OneQuadruple(oneQuadruple)
  {}

  /** Returns whether the vertex found a place at which the energy is less than before; if not, the complex is as it
   * was. `imageNeighbors` are the cells that meet the vertex's cell in the image, without the exterior. */
  bool
  Relocate(VertexId vertex, const std::vector<VertexId> & imageNeighbors)
  {
    Journal journal(m_State);
    if (this->TakeOut(vertex, journal))
    {
      const std::size_t taken = journal.Size();
      for (const VertexQuadruple & place : this->FindPlaces(vertex, imageNeighbors))
      {
        this->PutIn(vertex, place, journal);
        if (journal.Best() > 0)
        {
          journal.UndoTo(journal.Best());
          return true;
        }
        journal.UndoTo(taken);
      }
    }
    journal.UndoTo(0);
    return false;
  }

private:
  /** Reduces the vertex to four neighbours, each time by the edge that costs least, and removes it. */
  bool
  TakeOut(VertexId vertex, Journal & journal) const
  {
    while (m_State.complex.NumberOfNeighbors(vertex) > 4)
    {
      Proposal best{ Verdict::EdgeExists, {} };
      double   least = std::numeric_limits<double>::infinity();
      for (const VertexId neighbor : this->GetNeighbors(vertex))
      {
        const VertexPair edge{ { std::min(vertex, neighbor), std::max(vertex, neighbor) } };
        if (m_State.complex.FindEdge(edge[0], edge[1])->degree > LargestDegree)
        {
          continue;
        }
        Proposal proposal = m_State.RemoveEdgeByReference(edge);
        if (proposal && m_State.energy.Difference(proposal.replacement) < least)
        {
          least = m_State.energy.Difference(proposal.replacement);
          best = std::move(proposal);
        }
      }
      if (!best)
      {
        return false;
      }
      journal.Do(best.replacement);
    }
    const Proposal removal = m_State.operations.RemoveVertex(vertex);
    if (removal)
    {
      journal.Do(removal.replacement);
    }
    return static_cast<bool>(removal);
  }

  /** Returns the vertices that are adjacent to a vertex, ascending. */
  std::vector<VertexId>
  GetNeighbors(VertexId vertex) const
  {
    std::vector<VertexId> neighbors;
    for (const TetrahedronId id : m_State.complex.GetStar(vertex))
    {
      const auto & vertices = m_State.complex.GetTetrahedron(id).vertices;
      std::copy_if(
        vertices.begin(), vertices.end(), std::back_inserter(neighbors), [vertex](VertexId v) { return v != vertex; });
    }
    SortUnique(neighbors);
    return neighbors;
  }

  /** Returns tetrahedra at the vertex's neighbours in the image that are not in the reference, the most promising
   * first: those where the vertex would make most quadruples of the reference come first, among them those where it
   * would have most neighbours of it. */
  std::vector<VertexQuadruple>
  FindPlaces(VertexId vertex, const std::vector<VertexId> & imageNeighbors) const
  {
    const ReferenceAdjacency &   reference = *m_State.energy.GetReference();
    std::vector<VertexQuadruple> candidates;
    for (const VertexId neighbor : imageNeighbors)
    {
      for (const TetrahedronId id : m_State.complex.GetStar(neighbor))
      {
        candidates.push_back(Canonical(m_State.complex.GetTetrahedron(id).vertices));
      }
    }
    SortUnique(candidates);

    std::vector<std::tuple<int, int, VertexQuadruple>> places;
    for (const VertexQuadruple & vertices : candidates)
    {
      if (reference.HasQuadruple(vertices))
      {
        continue;
      }
      int quadruples = 0;
      int pairs = 0;
      for (int i = 0; i < 4; ++i)
      {
        VertexQuadruple created = vertices;
        created[i] = vertex;
        quadruples += reference.HasQuadruple(created) ? 1 : 0;
        pairs += reference.HasPair(vertex, vertices[i]) ? 1 : 0;
      }
      places.emplace_back(-quadruples, -pairs, vertices);
    }
    const std::size_t n = std::min<std::size_t>(places.size(), static_cast<std::size_t>(m_Parameters.numberOfPlaces));
    std::partial_sort(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(n), places.end());
    std::vector<VertexQuadruple> best;
    for (std::size_t i = 0; i < n; ++i)
    {
      best.push_back(std::get<2>(places[i]));
    }
    return best;
  }

  /** Inserts the vertex into the tetrahedron of these vertices and anneals around it. */
  void
  PutIn(VertexId vertex, const VertexQuadruple & place, Journal & journal)
  {
    const VertexId      any = place[0] == ExteriorVertex ? place[1] : place[0];
    const auto          star = m_State.complex.GetStar(any);
    const TetrahedronId id = *std::find_if(star.begin(), star.end(), [&](TetrahedronId t) {
      return Canonical(m_State.complex.GetTetrahedron(t).vertices) == place;
    });
    journal.Do(m_State.operations.InsertVertex(vertex, id).replacement);
    const Cooling cooling{ m_Parameters.initialTemperature,
                           m_Parameters.finalTemperature,
                           m_Parameters.numberOfRounds };
    for (int round = 0; round < m_Parameters.numberOfRounds; ++round)
    {
      const double                     temperature = m_OneQuadruple * cooling.Temperature(round);
      const std::vector<TetrahedronId> list = this->ListWrongAround(vertex);
      const std::size_t                n = list.size() * static_cast<std::size_t>(m_Parameters.proposalsPerTetrahedron);
      for (std::size_t i = 0; i < n; ++i)
      {
        const TetrahedronId at = list[m_State.random.Index(list.size())];
        if (m_State.complex.IsAlive(at))
        {
          journal.Try(m_State.ProposeAt(at, LargestDegree), temperature);
        }
      }
    }
  }

  /** Returns those tetrahedra of the star of a vertex, and of those that border on it, that are not in the reference,
   * and their neighbours. */
  std::vector<TetrahedronId>
  ListWrongAround(VertexId vertex) const
  {
    std::vector<TetrahedronId> list = m_State.complex.GetStar(vertex);
    for (std::size_t k = 0, n = list.size(); k < n; ++k)
    {
      const auto & t = m_State.complex.GetTetrahedron(list[k]);
      list.push_back(t.neighbors[std::find(t.vertices.begin(), t.vertices.end(), vertex) - t.vertices.begin()]);
    }
    return m_State.WrongAndNeighbors(list);
  }

  /** The largest degree of an edge that is removed, as in FocusedAnnealingParameters: to triangulate a ring takes time
   * in the cube of its length, and removals of large degrees hardly matter. */
  static constexpr std::int32_t LargestDegree = 8;

  AnnealingState &                   m_State;
  const VertexRelocationParameters & m_Parameters;
  double                             m_OneQuadruple;
};

/** Returns for each of the vertices the others in its quadruples, ascending, without the exterior. */
std::map<VertexId, std::vector<VertexId>>
CollectNeighbors(const std::vector<VertexQuadruple> &                   quadruples,
                 const std::vector<std::pair<std::int32_t, VertexId>> & vertices)
{
  std::map<VertexId, std::vector<VertexId>> neighbors;
  for (const auto & entry : vertices)
  {
    neighbors[entry.second];
  }
  for (const VertexQuadruple & quadruple : quadruples)
  {
    for (const VertexId v : quadruple)
    {
      const auto at = neighbors.find(v);
      if (at != neighbors.end())
      {
        std::copy_if(quadruple.begin(), quadruple.end(), std::back_inserter(at->second), [v](VertexId other) {
          return other != v && other != ExteriorVertex;
        });
      }
    }
  }
  for (auto & entry : neighbors)
  {
    SortUnique(entry.second);
  }
  return neighbors;
}
} // namespace

std::size_t
RelocateVertices(AnnealingState & state, const VertexRelocationParameters & parameters, double oneQuadruple,
                 const Execution & execution)
{
  // Each vertex is judged by how many quadruples the reference has for it and how many of them its star lacks or has
  // too many. The wrong ones are ordered, the worst first, and tried in that order, at most a share of all vertices.
  const ReferenceAdjacency &         reference = *state.energy.GetReference();
  const std::vector<VertexQuadruple> quadruples = reference.GetQuadruples();
  std::vector<std::int32_t>          wanted(static_cast<std::size_t>(state.complex.NumberOfVertices()), 0);
  for (const VertexQuadruple & quadruple : quadruples)
  {
    for (const VertexId v : quadruple)
    {
      ++wanted[v];
    }
  }
  // The number of quadruples that the vertex lacks, and of tetrahedra that it has too many.
  const auto countWrong = [&](VertexId v) {
    std::int32_t hits = 0;
    const auto   star = state.complex.GetStar(v);
    for (const TetrahedronId id : star)
    {
      hits += reference.HasQuadruple(state.complex.GetTetrahedron(id).vertices) ? 1 : 0;
    }
    return wanted[v] + static_cast<std::int32_t>(star.size()) - 2 * hits;
  };
  const auto isWrong = [&](std::int32_t wrong, VertexId v) { return wrong > parameters.wrongShare * wanted[v]; };

  std::vector<std::pair<std::int32_t, VertexId>> order; // The worst vertex comes first.
  for (VertexId v = ExteriorVertex + 1; v < state.complex.NumberOfVertices(); ++v)
  {
    const std::int32_t wrong = countWrong(v);
    if (isWrong(wrong, v))
    {
      order.emplace_back(-wrong, v);
    }
  }
  std::sort(order.begin(), order.end());
  const auto most = static_cast<std::size_t>(parameters.largestShare * state.complex.NumberOfVertices()) + 1;
  order.resize(std::min(order.size(), most));

  const auto  neighbors = CollectNeighbors(quadruples, order);
  Relocation  relocation(state, parameters, oneQuadruple);
  std::size_t relocated = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    execution.Report(static_cast<double>(i) / static_cast<double>(order.size()));
    // The relocation of an earlier vertex may have mended this one as well.
    const VertexId v = order[i].second;
    if (isWrong(countWrong(v), v))
    {
      relocated += relocation.Relocate(v, neighbors.at(v)) ? 1 : 0;
    }
  }
  return relocated;
}
} // namespace tissue
