/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/QuadrupleSet.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace tissue
{
namespace
{
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

QuadrupleSet::QuadrupleSet(VertexId numberOfVertices, const std::vector<VertexQuadruple> & quadruples)
{
  const auto n = static_cast<std::size_t>(numberOfVertices);
  if (n > IdMask + 1)
  {
    throw std::invalid_argument("QuadrupleSet: " + std::to_string(n - 1) + " cells, at most " + std::to_string(IdMask) +
                                " are possible");
  }
  m_Others.Assign(n, [&quadruples](const auto & add) {
    for (const VertexQuadruple & q : quadruples)
    {
      add(static_cast<std::size_t>(q[3]), Pack(q[0], q[1], q[2]));
    }
  });

  constexpr std::size_t bitsPerQuadruple = 24;
  m_Filter.assign(FilterWindow + this->Size() * bitsPerQuadruple / 64, 0);
  m_FilterWordsPerVertex = ((m_Filter.size() - FilterWindow) << 32) / std::max<std::size_t>(n, 1);
  for (const VertexQuadruple & q : quadruples)
  {
    const std::size_t bit = this->FilterBit(Pack(q[0], q[1], q[2]), q[3]);
    m_Filter[bit / 64] |= std::uint64_t{ 1 } << (bit % 64);
  }
}

std::size_t
QuadrupleSet::FilterBit(std::uint64_t others, VertexId largest) const
{
  const std::uint64_t hash = Hash(others, largest);
  const std::uint64_t first = (static_cast<std::uint64_t>(largest) * m_FilterWordsPerVertex) >> 32;
  return (first << 6) + (hash >> FilterShift);
}

std::ptrdiff_t
QuadrupleSet::Find(const VertexQuadruple & vertices) const
{
  VertexQuadruple key = vertices;
  SortFour(key);
  const std::uint64_t others = Pack(key[0], key[1], key[2]);
  const std::size_t   bit = this->FilterBit(others, key[3]);
  if ((m_Filter[bit / 64] >> (bit % 64) & 1) == 0)
  {
    return NotFound;
  }
  const auto row = m_Others[static_cast<std::size_t>(key[3])];
  const auto at = std::lower_bound(row.begin(), row.end(), others);
  return at != row.end() && *at == others ? at - m_Others.Items().data() : NotFound;
}

std::vector<VertexQuadruple>
QuadrupleSet::List() const
{
  std::vector<VertexQuadruple> quadruples;
  quadruples.reserve(this->Size());
  for (std::size_t largest = 0; largest < m_Others.NumberOfRows(); ++largest)
  {
    for (const std::uint64_t others : m_Others[largest])
    {
      quadruples.push_back({ { static_cast<VertexId>(others >> (2 * IdBits)),
                               static_cast<VertexId>((others >> IdBits) & IdMask),
                               static_cast<VertexId>(others & IdMask),
                               static_cast<VertexId>(largest) } });
    }
  }
  return quadruples;
}
} // namespace tissue
