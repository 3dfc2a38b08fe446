/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_QuadrupleSet_h
#define TissueTessellationCore_QuadrupleSet_h

#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Common/Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tissue
{
/** \brief A set of quadruples of vertices, made to be asked for many that it does not hold. */
class QuadrupleSet
{
public:
  static constexpr std::ptrdiff_t NotFound = -1;

  /** \param quadruples each once, ascending within, and all of them by the smaller three of each.
   * \throws std::invalid_argument for more than 2 097 151 cells: ids are kept in 21 bits. */
  QuadrupleSet(VertexId numberOfVertices, const std::vector<VertexQuadruple> & quadruples);

  /** The place of a quadruple, of vertices in any order, in List(), or NotFound. */
  std::ptrdiff_t
  Find(const VertexQuadruple & vertices) const;

  /** All quadruples, ascending within each, by the largest vertex first. */
  std::vector<VertexQuadruple>
  List() const;

  std::size_t
  Size() const
  {
    return m_Others.Items().size();
  }

private:
  /** Where the filter has the bit of a quadruple: near those of the quadruples with a largest vertex near by. */
  std::size_t
  FilterBit(std::uint64_t others, VertexId largest) const;

  /** The row of a vertex holds the quadruples of which it is the largest, by the others, ascending, packed into one
   * number. */
  CompressedRows<std::uint64_t> m_Others;
  /** A bit for the hash of each quadruple: most of those that are asked for are not there, and stop here. */
  std::vector<std::uint64_t> m_Filter;
  /** Words of the filter a vertex, in units of 2^-32. */
  std::uint64_t m_FilterWordsPerVertex = 0;
};
} // namespace tissue

#endif
