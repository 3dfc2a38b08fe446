/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CompressedRows_h
#define TissueTessellationCore_CompressedRows_h

#include <cstddef>
#include <vector>

namespace tissue
{
/** \brief Items grouped by an integer key: the row of each key, all of them in one array.
 *
 * Made in linear time, without a sort. Within a row the items have the order in which they were given, so it ascends
 * where they did. TOffset counts all items; 32 bits of it take half of the memory. */
template <typename TItem, typename TOffset = std::size_t>
class CompressedRows
{
public:
  /** The items of one key. */
  template <typename T>
  class Range
  {
  public:
    Range(T * begin, T * end)
      : m_Begin(begin)
      , m_End(end)
    {}

    T *
    begin() const
    {
      return m_Begin;
    }

    T *
    end() const
    {
      return m_End;
    }

    std::size_t
    size() const
    {
      return static_cast<std::size_t>(m_End - m_Begin);
    }

  private:
    T * m_Begin;
    T * m_End;
  };

  CompressedRows() = default;

  /** \param giveAll is called twice, as giveAll(add), and calls add(key, item) for each item, with keys of 0 to
   * numberOfRows - 1, both times in the same order. */
  template <typename TGiveAll>
  CompressedRows(std::size_t numberOfRows, const TGiveAll & giveAll)
  {
    this->Assign(numberOfRows, giveAll);
  }

  /** The same for an object that has its memory from an earlier use. */
  template <typename TGiveAll>
  void
  Assign(std::size_t numberOfRows, const TGiveAll & giveAll)
  {
    // A row is counted two places after its own, so that its begin, one place after, can go on to its end as it is
    // filled, where the next row begins.
    m_Begins.assign(numberOfRows + 2, 0);
    giveAll([this](std::size_t key, const TItem &) { ++m_Begins[key + 2]; });
    for (std::size_t row = 2; row < m_Begins.size(); ++row)
    {
      m_Begins[row] += m_Begins[row - 1];
    }
    m_Items.resize(static_cast<std::size_t>(m_Begins.back()));
    giveAll([this](std::size_t key, const TItem & item) { m_Items[m_Begins[key + 1]++] = item; });
    m_Begins.pop_back();
  }

  std::size_t
  NumberOfRows() const
  {
    return m_Begins.empty() ? 0 : m_Begins.size() - 1;
  }

  Range<const TItem>
  operator[](std::size_t key) const
  {
    return { m_Items.data() + m_Begins[key], m_Items.data() + m_Begins[key + 1] };
  }

  Range<TItem>
  operator[](std::size_t key)
  {
    return { m_Items.data() + m_Begins[key], m_Items.data() + m_Begins[key + 1] };
  }

  /** The items of all rows, one row after the other. */
  const std::vector<TItem> &
  Items() const
  {
    return m_Items;
  }

private:
  /** Of each row, and the end of the last. */
  std::vector<TOffset> m_Begins;
  std::vector<TItem>   m_Items;
};
} // namespace tissue

#endif
