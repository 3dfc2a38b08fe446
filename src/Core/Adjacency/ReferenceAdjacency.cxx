/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/ReferenceAdjacency.h"

#include <algorithm>

namespace tissue
{
namespace
{
std::vector<VertexQuadruple>
ListQuadruples(const std::vector<JunctionVote> & votes)
{
  std::vector<VertexQuadruple> quadruples;
  quadruples.reserve(votes.size());
  for (const JunctionVote & vote : votes)
  {
    quadruples.push_back(vote.cells);
  }
  return quadruples;
}
} // namespace

JunctionVotes::JunctionVotes(VertexId numberOfVertices, const std::vector<JunctionVote> & votes)
  : m_Quadruples(numberOfVertices, ListQuadruples(votes))
  , m_Shares(votes.size())
{
  for (const JunctionVote & vote : votes)
  {
    m_Shares[static_cast<std::size_t>(m_Quadruples.Find(vote.cells))] = vote.share;
  }
}

std::vector<JunctionVote>
JunctionVotes::List() const
{
  std::vector<JunctionVote> votes;
  votes.reserve(m_Shares.size());
  for (const VertexQuadruple & quadruple : m_Quadruples.List())
  {
    votes.push_back({ quadruple, m_Shares[votes.size()] });
  }
  return votes;
}

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
  : m_Smaller(static_cast<std::size_t>(numberOfVertices),
              [&pairs](const auto & add) {
                for (const VertexPair & pair : pairs)
                {
                  add(static_cast<std::size_t>(pair[1]), pair[0]);
                }
              })
  , m_Quadruples(numberOfVertices, quadruples)
  , m_Votes(numberOfVertices, votes)
{}

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
  return {
    this->NumberOfVertices(), RenumberTuples(this->GetPairs(), ids), RenumberTuples(this->GetQuadruples(), ids), votes
  };
}

bool
ReferenceAdjacency::HasPair(VertexId u, VertexId v) const
{
  const auto row = m_Smaller[static_cast<std::size_t>(std::max(u, v))];
  return std::binary_search(row.begin(), row.end(), std::min(u, v));
}

bool
ReferenceAdjacency::AreNeighbors(const VertexQuadruple & vertices) const
{
  const auto & [a, b, c, d] = vertices;
  return this->HasPair(a, b) && this->HasPair(a, c) && this->HasPair(a, d) && this->HasPair(b, c) &&
         this->HasPair(b, d) && this->HasPair(c, d);
}

std::vector<VertexPair>
ReferenceAdjacency::GetPairs() const
{
  std::vector<VertexPair> pairs;
  pairs.reserve(this->NumberOfPairs());
  for (std::size_t larger = 0; larger < m_Smaller.NumberOfRows(); ++larger)
  {
    for (const VertexId smaller : m_Smaller[larger])
    {
      pairs.push_back({ { smaller, static_cast<VertexId>(larger) } });
    }
  }
  return pairs;
}
} // namespace tissue
