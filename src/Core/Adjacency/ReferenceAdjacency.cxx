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
std::vector<TTuple>
RenumberTuples(std::vector<TTuple> tuples, const std::vector<VertexId> & ids)
{
  for (TTuple & tuple : tuples)
  {
    std::transform(tuple.begin(), tuple.end(), tuple.begin(), [&ids](VertexId v) { return ids[v]; });
    std::sort(tuple.begin(), tuple.end());
  }
  std::sort(tuples.begin(), tuples.end());
  return tuples;
}
} // namespace

ReferenceAdjacency::ReferenceAdjacency(const JunctionSet & junctions)
  : ReferenceAdjacency(junctions.NumberOfVertices(), ListTuples(junctions.walls), ListTuples(junctions.junctions))
{}

ReferenceAdjacency::ReferenceAdjacency(VertexId numberOfVertices, const std::vector<VertexPair> & pairs,
                                       const std::vector<VertexQuadruple> & quadruples)
  : m_Smaller(static_cast<std::size_t>(numberOfVertices),
              [&pairs](const auto & add) {
                for (const VertexPair & pair : pairs)
                {
                  add(static_cast<std::size_t>(pair[1]), pair[0]);
                }
              })
  , m_Quadruples(numberOfVertices, quadruples)
{}

ReferenceAdjacency
ReferenceAdjacency::Renumbered(const std::vector<VertexId> & ids) const
{
  return { this->NumberOfVertices(),
           RenumberTuples(this->GetPairs(), ids),
           RenumberTuples(this->GetQuadruples(), ids) };
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
