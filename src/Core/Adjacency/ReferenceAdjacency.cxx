/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Adjacency/ReferenceAdjacency.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** The vertices of walls or junctions. */
template <typename TEntry>
auto
ListTuples(const std::vector<TEntry> & entries)
{
  std::vector<decltype(TEntry::cells)> tuples;
  tuples.reserve(entries.size());
  for (const TEntry & entry : entries)
  {
    tuples.push_back(entry.cells);
  }
  return tuples;
}

template <typename TTuple>
void
RenumberTuple(TTuple & tuple, const std::vector<VertexId> & ids)
{
  for (VertexId & v : tuple)
  {
    v = ids[v];
  }
  std::sort(tuple.begin(), tuple.end());
}

template <typename TTuple>
std::vector<TTuple>
RenumberTuples(std::vector<TTuple> tuples, const std::vector<VertexId> & ids)
{
  for (TTuple & tuple : tuples)
  {
    RenumberTuple(tuple, ids);
  }
  std::sort(tuples.begin(), tuples.end());
  return tuples;
}
} // namespace

ReferenceAdjacency::ReferenceAdjacency(const JunctionSet & junctions)
  : ReferenceAdjacency(junctions.NumberOfVertices(), ListTuples(junctions.walls), ListTuples(junctions.junctions),
                       junctions.votes)
{}

ReferenceAdjacency::ReferenceAdjacency(VertexId numberOfVertices, const std::vector<VertexPair> & pairs,
                                       const std::vector<VertexQuadruple> & quadruples,
                                       const std::vector<JunctionVote> &    votes)
  : m_PairRows(CountRows(static_cast<std::size_t>(numberOfVertices), pairs))
  , m_Smaller(pairs.size())
  , m_Quadruples(numberOfVertices, quadruples)
  , m_Votes(numberOfVertices, votes)
{
  std::vector<std::size_t> next(m_PairRows.begin(), m_PairRows.end() - 1);
  for (const VertexPair & pair : pairs)
  {
    m_Smaller[next[pair[1]]++] = pair[0];
  }
}

ReferenceAdjacency
ReferenceAdjacency::Renumbered(const std::vector<VertexId> & ids) const
{
  std::vector<JunctionVote> votes = m_Votes.List();
  for (JunctionVote & vote : votes)
  {
    RenumberTuple(vote.cells, ids);
  }
  std::sort(
    votes.begin(), votes.end(), [](const JunctionVote & a, const JunctionVote & b) { return a.cells < b.cells; });
  return { static_cast<VertexId>(m_PairRows.size() - 1),
           RenumberTuples(this->GetPairs(), ids),
           RenumberTuples(this->GetQuadruples(), ids),
           votes };
}

bool
ReferenceAdjacency::HasPair(VertexId u, VertexId v) const
{
  const VertexId row = std::max(u, v);
  const auto     begin = m_Smaller.begin() + static_cast<std::ptrdiff_t>(m_PairRows[row]);
  const auto     end = m_Smaller.begin() + static_cast<std::ptrdiff_t>(m_PairRows[row + 1]);
  return std::binary_search(begin, end, std::min(u, v));
}

std::vector<VertexPair>
ReferenceAdjacency::GetPairs() const
{
  std::vector<VertexPair> pairs;
  pairs.reserve(m_Smaller.size());
  for (std::size_t row = 0; row + 1 < m_PairRows.size(); ++row)
  {
    for (std::size_t i = m_PairRows[row]; i < m_PairRows[row + 1]; ++i)
    {
      pairs.push_back({ { m_Smaller[i], static_cast<VertexId>(row) } });
    }
  }
  return pairs;
}

AdjacencyOverlap
ComputeAdjacencyOverlap(const AdjacencyComplex & complex, const ReferenceAdjacency & reference)
{
  const auto edges = complex.GetEdges();
  const auto tetrahedra = complex.GetTetrahedra();
  const auto commonPairs = std::count_if(edges.begin(), edges.end(), [&](const AdjacencyComplex::Edge & edge) {
    return reference.HasPair(edge.vertices[0], edge.vertices[1]);
  });
  const auto commonQuadruples = std::count_if(
    tetrahedra.begin(), tetrahedra.end(), [&](const VertexQuadruple & t) { return reference.HasQuadruple(t); });
  return { Jaccard(static_cast<std::size_t>(commonPairs), edges.size(), reference.NumberOfPairs()),
           Jaccard(static_cast<std::size_t>(commonQuadruples), tetrahedra.size(), reference.NumberOfQuadruples()) };
}

AdjacencyOverlap
ComputeAdjacencyOverlap(std::vector<VertexQuadruple> tetrahedra, const std::vector<VertexId> & ids,
                        const ReferenceAdjacency & reference)
{
  const auto makeUnique = [](auto & tuples) {
    std::sort(tuples.begin(), tuples.end());
    tuples.erase(std::unique(tuples.begin(), tuples.end()), tuples.end());
  };
  std::vector<VertexPair> edges;
  for (VertexQuadruple & t : tetrahedra)
  {
    std::sort(t.begin(), t.end());
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        edges.push_back({ { t[i], t[j] } });
      }
    }
  }
  makeUnique(tetrahedra);
  makeUnique(edges);
  const auto isKnown = [&ids](VertexId v) { return ids[v] >= 0; };
  const auto commonPairs = std::count_if(edges.begin(), edges.end(), [&](const VertexPair & e) {
    return std::all_of(e.begin(), e.end(), isKnown) && reference.HasPair(ids[e[0]], ids[e[1]]);
  });
  const auto commonQuadruples = std::count_if(tetrahedra.begin(), tetrahedra.end(), [&](const VertexQuadruple & t) {
    return std::all_of(t.begin(), t.end(), isKnown) &&
           reference.HasQuadruple({ { ids[t[0]], ids[t[1]], ids[t[2]], ids[t[3]] } });
  });
  return { Jaccard(static_cast<std::size_t>(commonPairs), edges.size(), reference.NumberOfPairs()),
           Jaccard(static_cast<std::size_t>(commonQuadruples), tetrahedra.size(), reference.NumberOfQuadruples()) };
}
} // namespace tissue
