/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_QuadrupleSet_h
#define TissueTessellationCore_QuadrupleSet_h

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
    return m_Others.size();
  }

private:
  /** Where the filter has the bit of a quadruple: near those of the quadruples with a largest vertex near by. */
  std::size_t
  FilterBit(std::uint64_t others, VertexId largest) const;

  /** Compressed rows: the row of a vertex holds the quadruples of which it is the largest, by the others, ascending,
   * packed into one number. */
  std::vector<std::size_t>   m_Rows;
  std::vector<std::uint64_t> m_Others;
  /** A bit for the hash of each quadruple: most of those that are asked for are not there, and stop here. */
  std::vector<std::uint64_t> m_Filter;
  /** Words of the filter a vertex, in units of 2^-32. */
  std::uint64_t m_FilterWordsPerVertex = 0;
};

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
} // namespace tissue

#endif
