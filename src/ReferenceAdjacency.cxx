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
/** Begins of rows, one for each vertex and one past the last, from the row of each entry. */
template <typename TTuples, typename TRow>
std::vector<std::size_t>
CountRows(std::size_t numberOfRows, const TTuples & tuples, const TRow & rowOf)
{
  std::vector<std::size_t> begins(numberOfRows + 1, 0);
  for (const auto & tuple : tuples)
  {
    ++begins[rowOf(tuple) + 1];
  }
  for (std::size_t row = 0; row < numberOfRows; ++row)
  {
    begins[row + 1] += begins[row];
  }
  return begins;
}
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
{
  const auto n = static_cast<std::size_t>(junctions.NumberOfVertices());
  if (n > IdMask + 1)
  {
    throw std::invalid_argument("ReferenceAdjacency: " + std::to_string(n - 1) + " cells, at most " +
                                std::to_string(IdMask) + " are possible");
  }
  m_PairRows = CountRows(n, junctions.walls, [](const Wall & wall) { return static_cast<std::size_t>(wall.cells[1]); });
  m_Smaller.resize(junctions.walls.size());
  std::vector<std::size_t> next(m_PairRows.begin(), m_PairRows.end() - 1);
  for (const Wall & wall : junctions.walls)
  {
    m_Smaller[next[wall.cells[1]]++] = wall.cells[0];
  }

  const auto last = [](const Junction & junction) { return static_cast<std::size_t>(junction.cells[3]); };
  m_QuadrupleRows = CountRows(n, junctions.junctions, last);
  m_Others.resize(junctions.junctions.size());
  next.assign(m_QuadrupleRows.begin(), m_QuadrupleRows.end() - 1);
  for (const Junction & junction : junctions.junctions)
  {
    m_Others[next[last(junction)]++] = Pack(junction.cells[0], junction.cells[1], junction.cells[2]);
  }

  // 16 to 32 bits a quadruple.
  int filterBits = 6;
  while ((std::size_t{ 1 } << filterBits) < 16 * m_Others.size())
  {
    ++filterBits;
  }
  m_FilterShift = 64 - filterBits;
  m_Filter.assign((std::size_t{ 1 } << filterBits) / 64, 0);
  for (const Junction & junction : junctions.junctions)
  {
    const VertexQuadruple & c = junction.cells;
    const std::uint64_t     bit = Hash(Pack(c[0], c[1], c[2]), c[3]) >> m_FilterShift;
    m_Filter[bit / 64] |= std::uint64_t{ 1 } << (bit % 64);
  }
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
  const std::uint64_t bit = Hash(others, key[3]) >> m_FilterShift;
  if ((m_Filter[bit / 64] >> (bit % 64) & 1) == 0)
  {
    return false;
  }
  const auto begin = m_Others.begin() + static_cast<std::ptrdiff_t>(m_QuadrupleRows[key[3]]);
  const auto end = m_Others.begin() + static_cast<std::ptrdiff_t>(m_QuadrupleRows[key[3] + 1]);
  return std::binary_search(begin, end, others);
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
} // namespace tissue
