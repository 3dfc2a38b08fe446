/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/ReferenceAdjacency.h"

#include <algorithm>
#include <stdexcept>
#include <string>

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
    for (VertexId & v : tuple)
    {
      v = ids[v];
    }
    std::sort(tuple.begin(), tuple.end());
  }
  std::sort(tuples.begin(), tuples.end());
  return tuples;
}

/** Begins of rows, one for each vertex and one past the last: a tuple is in the row of its largest vertex. */
template <typename TTuple>
std::vector<std::size_t>
CountRows(std::size_t numberOfRows, const std::vector<TTuple> & tuples)
{
  std::vector<std::size_t> begins(numberOfRows + 1, 0);
  for (const TTuple & tuple : tuples)
  {
    ++begins[static_cast<std::size_t>(tuple.back()) + 1];
  }
  for (std::size_t row = 0; row < numberOfRows; ++row)
  {
    begins[row + 1] += begins[row];
  }
  return begins;
}

/** Words of the filter in which a quadruple may have its bit, a power of two, and what is left of a hash for them. */
constexpr std::size_t FilterWindow = 8;
constexpr int         FilterShift = 64 - 3 - 6;

/** Bits of a vertex id in a packed triple. */
constexpr int           IdBits = 21;
constexpr std::uint64_t IdMask = (std::uint64_t{ 1 } << IdBits) - 1;

/** Orders as the triples do. */
std::uint64_t
Pack(VertexId a, VertexId b, VertexId c)
{
  return (static_cast<std::uint64_t>(a) << (2 * IdBits)) | (static_cast<std::uint64_t>(b) << IdBits) |
         static_cast<std::uint64_t>(c);
}

/** Multiplicative hash of a quadruple; its upper bits are the good ones. */
std::uint64_t
Hash(std::uint64_t packedOthers, VertexId largest)
{
  constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;
  return (packedOthers ^ (static_cast<std::uint64_t>(largest) * golden)) * golden;
}

/** Sorts four numbers by the shortest network. */
void
SortFour(VertexQuadruple & v)
{
  const auto order = [&v](int i, int j) {
    const VertexId smaller = std::min(v[i], v[j]);
    v[j] = std::max(v[i], v[j]);
    v[i] = smaller;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
}
} // namespace

ReferenceAdjacency::ReferenceAdjacency(const JunctionSet & junctions)
  : ReferenceAdjacency(junctions.NumberOfVertices(), ListTuples(junctions.walls), ListTuples(junctions.junctions))
{}

ReferenceAdjacency::ReferenceAdjacency(VertexId numberOfVertices, const std::vector<VertexPair> & pairs,
                                       const std::vector<VertexQuadruple> & quadruples)
{
  const auto n = static_cast<std::size_t>(numberOfVertices);
  if (n > IdMask + 1)
  {
    throw std::invalid_argument("ReferenceAdjacency: " + std::to_string(n - 1) + " cells, at most " +
                                std::to_string(IdMask) + " are possible");
  }
  m_PairRows = CountRows(n, pairs);
  m_Smaller.resize(pairs.size());
  std::vector<std::size_t> next(m_PairRows.begin(), m_PairRows.end() - 1);
  for (const VertexPair & pair : pairs)
  {
    m_Smaller[next[pair[1]]++] = pair[0];
  }

  m_QuadrupleRows = CountRows(n, quadruples);
  m_Others.resize(quadruples.size());
  next.assign(m_QuadrupleRows.begin(), m_QuadrupleRows.end() - 1);
  for (const VertexQuadruple & q : quadruples)
  {
    m_Others[next[q[3]]++] = Pack(q[0], q[1], q[2]);
  }

  constexpr std::size_t bitsPerQuadruple = 24;
  m_Filter.assign(FilterWindow + m_Others.size() * bitsPerQuadruple / 64, 0);
  m_FilterWordsPerVertex = ((m_Filter.size() - FilterWindow) << 32) / std::max<std::size_t>(n, 1);
  for (const VertexQuadruple & q : quadruples)
  {
    const std::size_t bit = this->FilterBit(Pack(q[0], q[1], q[2]), q[3]);
    m_Filter[bit / 64] |= std::uint64_t{ 1 } << (bit % 64);
  }
}

ReferenceAdjacency
ReferenceAdjacency::Renumbered(const std::vector<VertexId> & ids) const
{
  return { static_cast<VertexId>(m_PairRows.size() - 1),
           RenumberTuples(this->GetPairs(), ids),
           RenumberTuples(this->GetQuadruples(), ids) };
}

std::size_t
ReferenceAdjacency::FilterBit(std::uint64_t others, VertexId largest) const
{
  const std::uint64_t hash = Hash(others, largest);
  const std::uint64_t first = (static_cast<std::uint64_t>(largest) * m_FilterWordsPerVertex) >> 32;
  return (first << 6) + (hash >> FilterShift);
}

bool
ReferenceAdjacency::HasPair(VertexId u, VertexId v) const
{
  const VertexId row = std::max(u, v);
  const auto     begin = m_Smaller.begin() + static_cast<std::ptrdiff_t>(m_PairRows[row]);
  const auto     end = m_Smaller.begin() + static_cast<std::ptrdiff_t>(m_PairRows[row + 1]);
  return std::binary_search(begin, end, std::min(u, v));
}

bool
ReferenceAdjacency::HasQuadruple(const VertexQuadruple & vertices) const
{
  VertexQuadruple key = vertices;
  SortFour(key);
  const std::uint64_t others = Pack(key[0], key[1], key[2]);
  const std::size_t   bit = this->FilterBit(others, key[3]);
  if ((m_Filter[bit / 64] >> (bit % 64) & 1) == 0)
  {
    return false;
  }
  const auto begin = m_Others.begin() + static_cast<std::ptrdiff_t>(m_QuadrupleRows[key[3]]);
  const auto end = m_Others.begin() + static_cast<std::ptrdiff_t>(m_QuadrupleRows[key[3] + 1]);
  return std::binary_search(begin, end, others);
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

std::vector<VertexQuadruple>
ReferenceAdjacency::GetQuadruples() const
{
  std::vector<VertexQuadruple> quadruples;
  quadruples.reserve(m_Others.size());
  for (std::size_t row = 0; row + 1 < m_QuadrupleRows.size(); ++row)
  {
    for (std::size_t i = m_QuadrupleRows[row]; i < m_QuadrupleRows[row + 1]; ++i)
    {
      quadruples.push_back({ { static_cast<VertexId>(m_Others[i] >> (2 * IdBits)),
                               static_cast<VertexId>((m_Others[i] >> IdBits) & IdMask),
                               static_cast<VertexId>(m_Others[i] & IdMask),
                               static_cast<VertexId>(row) } });
    }
  }
  return quadruples;
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
