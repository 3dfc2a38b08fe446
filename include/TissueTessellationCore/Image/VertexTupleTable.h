/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_VertexTupleTable_h
#define TissueTessellationCore_VertexTupleTable_h

#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
/** \brief Hash table from a tuple of vertices to a value, for the inner loop of the image scan.
 *
 * It uses open addressing, and first tries whether a tuple is the same as the last one, which is so for every second
 * block along a line of the image. The entries keep the order of their insertion. */
template <std::size_t VLength, typename TValue>
class VertexTupleTable
{
public:
  using Key = std::array<VertexId, VLength>;
  struct Entry
  {
    Key    key;
    TValue value;
  };

  VertexTupleTable()
    : m_Slots(std::size_t{ 1 } << 10, -1)
  {}

  /** The value of a tuple. It is a new one if the table has none. The reference holds until the next call. */
  TValue &
  operator[](const Key & key)
  {
    if (m_Last < m_Entries.size() && AreEqual(m_Entries[m_Last].key, key))
    {
      return m_Entries[m_Last].value;
    }
    std::size_t slot = this->FindSlot(key);
    if (m_Slots[slot] < 0)
    {
      if (2 * (m_Entries.size() + 1) > m_Slots.size())
      {
        this->Grow();
        slot = this->FindSlot(key);
      }
      m_Slots[slot] = static_cast<std::int64_t>(m_Entries.size());
      m_Entries.push_back(Entry{ key, TValue() });
    }
    m_Last = static_cast<std::size_t>(m_Slots[slot]);
    return m_Entries[m_Last].value;
  }

  const std::vector<Entry> &
  GetEntries() const
  {
    return m_Entries;
  }

private:
  /** The operator of std::array may call memcmp, which takes longer than the comparison. */
  static bool
  AreEqual(const Key & a, const Key & b)
  {
    VertexId difference = 0;
    for (std::size_t i = 0; i < VLength; ++i)
    {
      difference |= a[i] ^ b[i];
    }
    return difference == 0;
  }

  /** The slot that holds the key, or the empty one where it belongs. */
  std::size_t
  FindSlot(const Key & key) const
  {
    // The factors are odd and without a pattern, and their products do not wait for each other.
    constexpr std::array<std::uint64_t, 3> factors = {
      { 0x9E3779B97F4A7C15u, 0xC2B2AE3D27D4EB4Fu, 0xD6E8FEB86659FD93u }
    };
    static_assert(VLength <= factors.size(), "A factor for each vertex.");
    std::uint64_t hash = 0;
    for (std::size_t i = 0; i < VLength; ++i)
    {
      hash += static_cast<std::uint32_t>(key[i]) * factors[i];
    }
    hash ^= hash >> 32;
    const std::size_t mask = m_Slots.size() - 1;
    std::size_t       slot = hash & mask;
    while (m_Slots[slot] >= 0 && !AreEqual(m_Entries[m_Slots[slot]].key, key))
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  void
  Grow()
  {
    m_Slots.assign(2 * m_Slots.size(), -1);
    for (std::size_t i = 0; i < m_Entries.size(); ++i)
    {
      m_Slots[this->FindSlot(m_Entries[i].key)] = static_cast<std::int64_t>(i);
    }
  }

  std::vector<Entry> m_Entries;
  /** The index of the entry in each slot, or -1. The number of slots is a power of two. */
  std::vector<std::int64_t> m_Slots;
  std::size_t               m_Last = 0;
};
} // namespace tissue

#endif
