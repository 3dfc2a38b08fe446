/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_DisjointSets_h
#define TissueTessellationCore_DisjointSets_h

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace tissue
{
/** Union-find over 0, 1, 2, ... The representative of a set is its smallest element, whatever the order of the unions.
 */
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size = 0)
    : m_Parents(size)
  {
    std::iota(m_Parents.begin(), m_Parents.end(), std::int64_t{ 0 });
  }

  /** Adds an element, as a set by itself, and returns it. */
  std::int64_t
  Add()
  {
    m_Parents.push_back(static_cast<std::int64_t>(m_Parents.size()));
    return m_Parents.back();
  }

  std::size_t
  GetSize() const
  {
    return m_Parents.size();
  }

  /** Returns the representative of the element's set. */
  std::int64_t
  Find(std::int64_t element)
  {
    while (m_Parents[element] != element)
    {
      m_Parents[element] = m_Parents[m_Parents[element]];
      element = m_Parents[element];
    }
    return element;
  }

  /** Joins the sets of two elements and returns the representative of the joined one. */
  std::int64_t
  Unite(std::int64_t a, std::int64_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    if (b < a)
    {
      std::swap(a, b);
    }
    m_Parents[b] = a;
    return a;
  }

private:
  std::vector<std::int64_t> m_Parents;
};
} // namespace tissue

#endif
