/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TupleCounts_h
#define TissueTessellationCore_TupleCounts_h

#include "TissueTessellationCore/Common/Types.h"

#include <cstdlib>
#include <vector>

namespace tissue
{
/** \brief Of tuples of vertices, how often each is wanted and how often it is there: a hash table with open addressing.
 *
 * Tuples are ascending. One that was never added is wanted and there zero times, has no votes, and costs no memory.
 *
 * The tuples with the same last half have one line of slots, so that what is asked around a cell, or around an edge, is
 * in few lines of the processor's cache, however large the table. What finds no room there, as of a vertex with very
 * many neighbours, lies anywhere. */
template <std::size_t VLength>
class TupleCounts
{
public:
  using Key = std::array<VertexId, VLength>;
  struct Entry
  {
    Key          key;
    std::int32_t wanted;
    std::int32_t present;
    /** The share of the votes that are for the tuple, where there are votes. */
    float share;
  };

  TupleCounts()
    : m_Slots(std::size_t{ 1 } << 10, -1)
  {}

  /** A copy of the tuple's counts. */
  Entry
  Get(const Key & key) const
  {
    const std::int32_t at = this->IndexOf(key);
    return at < 0 ? Entry{ key, 0, 0, 0.0F } : m_Entries[static_cast<std::size_t>(at)];
  }

  /** Of the tuple among the entries, where it stays; -1 where it was never added. */
  std::int32_t
  IndexOf(const Key & key) const
  {
    return m_Slots[this->FindSlot(key)];
  }

  /** The tuple's counts, for a change. The reference holds until the next call. */
  Entry &
  operator[](const Key & key)
  {
    std::size_t slot = this->FindSlot(key);
    if (m_Slots[slot] < 0)
    {
      if (2 * (m_Entries.size() + 1) > m_Slots.size())
      {
        this->Grow();
        slot = this->FindSlot(key);
      }
      m_Slots[slot] = static_cast<std::int32_t>(m_Entries.size());
      m_Entries.push_back({ key, 0, 0, 0.0F });
    }
    return m_Entries[static_cast<std::size_t>(m_Slots[slot])];
  }

  const std::vector<Entry> &
  GetEntries() const
  {
    return m_Entries;
  }

private:
  /** The slot that holds the key, or the empty one where it belongs. */
  std::size_t
  FindSlot(const Key & key) const
  {
    const std::size_t mask = m_Slots.size() - 1;
    const std::size_t hash = Hash(key);
    const std::size_t line = LineOf(key) * SlotsOfLine & mask;
    for (std::size_t i = 0; i < SlotsOfLine; ++i)
    {
      const std::size_t slot = line + (hash + i) % SlotsOfLine;
      if (this->IsEmptyOrOf(slot, key))
      {
        return slot;
      }
    }
    std::size_t slot = hash / SlotsOfLine & mask;
    while (!this->IsEmptyOrOf(slot, key))
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  bool
  IsEmptyOrOf(std::size_t slot, const Key & key) const
  {
    return m_Slots[slot] < 0 || AreEqual(m_Entries[static_cast<std::size_t>(m_Slots[slot])].key, key);
  }

  /** Neighbours in the numbers of the last vertices have neighbouring lines. */
  static std::size_t
  LineOf(const Key & key)
  {
    std::size_t line = 0;
    for (std::size_t i = VLength / 2; i < VLength; ++i)
    {
      line = line * 0x9E3779B97F4A7C15u + static_cast<std::size_t>(key[i]);
    }
    return line;
  }

  /** FNV-1a by whole numbers, and a last mix, as the low bits choose the slot. */
  static std::size_t
  Hash(const Key & key)
  {
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (const VertexId v : key)
    {
      hash = (hash ^ static_cast<std::uint32_t>(v)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }

  /** As by ==, which compilers make a call of that costs more than the comparison. */
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

  void
  Grow()
  {
    m_Slots.assign(2 * m_Slots.size(), -1);
    for (std::size_t i = 0; i < m_Entries.size(); ++i)
    {
      m_Slots[this->FindSlot(m_Entries[i].key)] = static_cast<std::int32_t>(i);
    }
  }

  /** A line of the processor's cache. */
  static constexpr std::size_t SlotsOfLine = 16;

  std::vector<Entry> m_Entries;
  /** Index of an entry, or -1; their number is a power of two. */
  std::vector<std::int32_t> m_Slots;
};
} // namespace tissue

#endif
