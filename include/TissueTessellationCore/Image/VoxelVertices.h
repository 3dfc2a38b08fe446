/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_VoxelVertices_h
#define TissueTessellationCore_VoxelVertices_h

#include "TissueTessellationCore/Common/Types.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <vector>

namespace tissue
{
/** \brief A vertex for each voxel of an image: a list of numbers that takes 2 bytes each while all of them are of
 * 0 ... 65535, and 4 bytes otherwise. */
class VoxelVertices
{
public:
  /** Over numbers that cannot be written to. */
  class Iterator
  {
  public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = VertexId;
    using difference_type = std::ptrdiff_t;
    using pointer = const VertexId *;
    using reference = VertexId;

    Iterator() = default;

    Iterator(const VoxelVertices & vertices, std::size_t i)
      : m_Vertices(&vertices)
      , m_I(i)
    {}

    VertexId
    operator*() const
    {
      return (*m_Vertices)[m_I];
    }

    Iterator &
    operator++()
    {
      ++m_I;
      return *this;
    }

    Iterator
    operator++(int)
    {
      return { *m_Vertices, m_I++ };
    }

    bool
    operator==(const Iterator & other) const
    {
      return m_I == other.m_I;
    }

    bool
    operator!=(const Iterator & other) const
    {
      return m_I != other.m_I;
    }

  private:
    const VoxelVertices * m_Vertices = nullptr;
    std::size_t           m_I = 0;
  };

  VoxelVertices() = default;

  /** So many of one vertex. \param largest the largest one that will be put there. */
  VoxelVertices(std::size_t size, VertexId vertex, VertexId largest = 0)
  {
    if (!IsNarrow(vertex) || !IsNarrow(largest))
    {
      m_Wide.assign(size, vertex);
      return;
    }
    m_Narrow.assign(size, static_cast<std::uint16_t>(vertex));
  }

  VoxelVertices(const std::vector<VertexId> & vertices)
    : VoxelVertices(vertices.begin(), vertices.end())
  {}

  VoxelVertices(std::initializer_list<VertexId> vertices)
    : VoxelVertices(vertices.begin(), vertices.end())
  {}

  template <typename TIterator, typename = typename std::iterator_traits<TIterator>::iterator_category>
  VoxelVertices(TIterator begin, TIterator end)
  {
    std::for_each(begin, end, [this](VertexId vertex) { this->push_back(vertex); });
  }

  std::size_t
  size() const
  {
    return m_Wide.empty() ? m_Narrow.size() : m_Wide.size();
  }

  bool
  empty() const
  {
    return this->size() == 0;
  }

  Iterator
  begin() const
  {
    return { *this, 0 };
  }

  Iterator
  end() const
  {
    return { *this, this->size() };
  }

  VertexId
  operator[](std::size_t i) const
  {
    return m_Wide.empty() ? m_Narrow[i] : m_Wide[i];
  }

  bool
  operator==(const VoxelVertices & other) const
  {
    return this->size() == other.size() && std::equal(this->begin(), this->end(), other.begin());
  }

  void
  push_back(VertexId vertex)
  {
    this->WidenFor(vertex);
    if (m_Wide.empty() && IsNarrow(vertex))
    {
      m_Narrow.push_back(static_cast<std::uint16_t>(vertex));
    }
    else
    {
      m_Wide.push_back(vertex);
    }
  }

  /** Puts a vertex in the place of another. */
  void
  Put(std::size_t i, VertexId vertex)
  {
    this->WidenFor(vertex);
    if (m_Wide.empty())
    {
      m_Narrow[i] = static_cast<std::uint16_t>(vertex);
    }
    else
    {
      m_Wide[i] = vertex;
    }
  }

  /** Puts a vertex in all places of [begin, end). */
  void
  Fill(std::size_t begin, std::size_t end, VertexId vertex)
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      this->Put(i, vertex);
    }
  }

  /** Puts a vertex in all places that another one has. */
  void
  Replace(VertexId old, VertexId vertex)
  {
    for (std::size_t i = 0; i < this->size(); ++i)
    {
      this->Put(i, (*this)[i] == old ? vertex : (*this)[i]);
    }
  }

  /** Returns what visit returns for a pointer to the first number, which is of one of two types. */
  template <typename TVisitor>
  auto
  Visit(const TVisitor & visit) const
  {
    return m_Wide.empty() ? visit(m_Narrow.data()) : visit(m_Wide.data());
  }

private:
  static bool
  IsNarrow(VertexId vertex)
  {
    return vertex >= 0 && vertex <= std::numeric_limits<std::uint16_t>::max();
  }

  void
  WidenFor(VertexId vertex)
  {
    if (m_Wide.empty() && !IsNarrow(vertex))
    {
      m_Wide.assign(m_Narrow.begin(), m_Narrow.end());
      m_Narrow = {};
    }
  }

  /** One of the two is empty. */
  std::vector<std::uint16_t> m_Narrow;
  std::vector<VertexId>      m_Wide;
};
} // namespace tissue

#endif
