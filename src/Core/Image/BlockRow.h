/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_BlockRow_h
#define TissueTessellationCore_BlockRow_h

#include "TissueTessellationCore/Image/LabelVolume.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

namespace tissue
{
/** The vertices of a 2x2x2 block of voxels, the first axis fastest. */
using BlockVoxels = std::array<VertexId, 8>;

/** \brief The 2x2x2 blocks of voxels along a row, with what is outside of the image.
 *
 * Nearly everywhere all columns of four voxels, across the row, are of one cell each. Two such columns side by side
 * tell nothing: no corner is there, and no cell's shape has more or less of a hole. So the row is read in stretches,
 * most of which are passed over at once. */
template <typename TVertex>
class BlockRow
{
public:
  /** Of the rows y and y + 1 in the planes z and z + 1, each of which may be outside.
   * \param vertices those of the volume (VoxelVertices::Visit()).
   * \param outside a row of exterior. */
  BlockRow(const LabelVolume & volume, const TVertex * vertices, const std::vector<TVertex> & outside, std::int32_t y,
           std::int32_t z)
    : m_Size(volume.size[0])
  {
    for (int i = 0; i < 4; ++i)
    {
      const std::int32_t rowY = y + i % 2;
      const std::int32_t rowZ = z + i / 2;
      const bool         isInside = rowY >= 0 && rowZ >= 0 && rowY < volume.size[1] && rowZ < volume.size[2];
      m_Rows[i] = isInside ? vertices + (static_cast<std::size_t>(rowZ) * volume.size[1] + rowY) * volume.size[0]
                           : outside.data();
    }
  }

  /** Calls visit(x, voxels) for each block with a column that is not of one cell, from that in front of the image on,
   * where x is -1. */
  template <typename TVisitor>
  void
  VisitMixed(const TVisitor & visit) const
  {
    Column left = Outside();
    for (std::int32_t begin = 0; begin < m_Size; begin += Stretch)
    {
      const std::int32_t end = std::min(begin + Stretch, m_Size);
      if (IsUniform(left) && this->AreUniform(begin, end))
      {
        left = this->ColumnAt(end - 1);
        continue;
      }
      for (std::int32_t x = begin; x < end; ++x)
      {
        const Column right = this->ColumnAt(x);
        VisitIfMixed(left, right, x - 1, visit);
        left = right;
      }
    }
    VisitIfMixed(left, Outside(), m_Size - 1, visit);
  }

private:
  using Column = std::array<TVertex, 4>;

  static constexpr std::int32_t Stretch = 16;

  static Column
  Outside()
  {
    return { { ExteriorVertex, ExteriorVertex, ExteriorVertex, ExteriorVertex } };
  }

  static bool
  IsUniform(const Column & column)
  {
    return column[0] == column[1] && column[0] == column[2] && column[0] == column[3];
  }

  Column
  ColumnAt(std::int32_t x) const
  {
    return { { m_Rows[0][x], m_Rows[1][x], m_Rows[2][x], m_Rows[3][x] } };
  }

  /** Whether all columns of [begin, end) are of one cell each. */
  bool
  AreUniform(std::int32_t begin, std::int32_t end) const
  {
    TVertex differences = 0;
    for (std::int32_t x = begin; x < end; ++x)
    {
      differences |= (m_Rows[0][x] ^ m_Rows[1][x]) | (m_Rows[0][x] ^ m_Rows[2][x]) | (m_Rows[0][x] ^ m_Rows[3][x]);
    }
    return differences == 0;
  }

  template <typename TVisitor>
  static void
  VisitIfMixed(const Column & left, const Column & right, std::int32_t x, const TVisitor & visit)
  {
    if (!IsUniform(left) || !IsUniform(right))
    {
      visit(x, BlockVoxels{ { left[0], right[0], left[1], right[1], left[2], right[2], left[3], right[3] } });
    }
  }

  std::array<const TVertex *, 4> m_Rows;
  std::int32_t                   m_Size;
};

/** Calls visit(x, y, voxels) for the blocks between the planes z and z + 1 that BlockRow::VisitMixed() visits, row by
 * row from that in front of the image on, where y is -1. */
template <typename TVisitor>
void
VisitMixedBlocks(const LabelVolume & volume, std::int32_t z, const TVisitor & visit)
{
  volume.vertices.Visit([&](const auto * vertices) {
    using Vertex = std::remove_cv_t<std::remove_reference_t<decltype(*vertices)>>;
    const std::vector<Vertex> outside(static_cast<std::size_t>(volume.size[0]), ExteriorVertex);
    for (std::int32_t y = -1; y < volume.size[1]; ++y)
    {
      BlockRow<Vertex>(volume, vertices, outside, y, z).VisitMixed([&](std::int32_t x, const BlockVoxels & voxels) {
        visit(x, y, voxels);
      });
    }
  });
}
} // namespace tissue

#endif
