/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_KeySet_h
#define TissueTessellationCore_KeySet_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tissue
{
/** A set of numbers that are not negative, in one array: a flood asks for millions of voxels whether it has been there.
 */
class KeySet
{
public:
  /** Returns false where the key is there already. */
  bool
  Insert(std::int64_t key)
  {
    if (2 * (m_Count + 1) > m_Slots.size())
    {
      this->Grow();
    }
    std::int64_t & slot = m_Slots[this->Find(key)];
    if (slot == key)
    {
      return false;
    }
    slot = key;
    ++m_Count;
    return true;
  }

  bool
  Contains(std::int64_t key) const
  {
    return m_Count > 0 && m_Slots[this->Find(key)] == key;
  }

  void
  Clear()
  {
    m_Slots.clear();
    m_Count = 0;
  }

private:
  static constexpr std::int64_t Empty = -1;

  /** The slot of the key, or the empty one where it is to be. */
  std::size_t
  Find(std::int64_t key) const
  {
    // Fibonacci hashing: neighbours in a row go to slots far apart, the upper bits tell which.
    std::size_t slot = (static_cast<std::uint64_t>(key) * 0x9E3779B97F4A7C15u) >> m_Shift;
    while (m_Slots[slot] != key && m_Slots[slot] != Empty)
    {
      slot = (slot + 1) & (m_Slots.size() - 1);
    }
    return slot;
  }

  void
  Grow()
  {
    std::vector<std::int64_t> old(m_Slots.empty() ? 16 : 2 * m_Slots.size(), Empty);
    old.swap(m_Slots);
    m_Shift = 64;
    for (std::size_t size = m_Slots.size(); size > 1; size /= 2)
    {
      --m_Shift;
    }
    for (const std::int64_t key : old)
    {
      if (key != Empty)
      {
        m_Slots[this->Find(key)] = key;
      }
    }
  }

  std::vector<std::int64_t> m_Slots;
  std::size_t               m_Count = 0;
  int                       m_Shift = 64;
};
} // namespace tissue

#endif
