/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/CrowdedBlocks.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** The rows of voxels that the blocks of one row have in common, with what is outside of the image. */
class BlockRow
{
public:
  BlockRow(const LabelVolume & volume, const std::vector<VertexId> & outside, std::int32_t y, std::int32_t z)
    : m_Size(volume.size[0])
    , m_Y(y)
    , m_Z(z)
  {
    for (int i = 0; i < 4; ++i)
    {
      const std::int32_t rowY = y + i % 2;
      const std::int32_t rowZ = z + i / 2;
      const bool         isInside = rowY >= 0 && rowZ >= 0 && rowY < volume.size[1] && rowZ < volume.size[2];
      m_Rows[i] = isInside
                    ? volume.vertices.data() + (static_cast<std::size_t>(rowZ) * volume.size[1] + rowY) * volume.size[0]
                    : outside.data();
    }
  }

  void
  Append(std::vector<CrowdedBlock> & blocks) const
  {
    std::array<VertexId, 4> left = Outside();
    bool                    isLeftUniform = true;
    for (std::int32_t x = -1; x < m_Size; ++x)
    {
      const bool                    isLast = x + 1 == m_Size;
      const std::array<VertexId, 4> right = isLast ? Outside() : this->Column(x + 1);
      const bool isRightUniform = right[0] == right[1] && right[0] == right[2] && right[0] == right[3];
      // Two columns of one cell each, as nearly everywhere, hold two cells at most.
      if (!isLeftUniform || !isRightUniform)
      {
        const CrowdedBlock block{ { { x, m_Y, m_Z } },
                                  { { left[0], right[0], left[1], right[1], left[2], right[2], left[3], right[3] } } };
        if (DifferentCells(block.cells).count >= 4)
        {
          blocks.push_back(block);
        }
      }
      left = right;
      isLeftUniform = isRightUniform;
    }
  }

private:
  static std::array<VertexId, 4>
  Outside()
  {
    return { { ExteriorVertex, ExteriorVertex, ExteriorVertex, ExteriorVertex } };
  }

  std::array<VertexId, 4>
  Column(std::int32_t x) const
  {
    return { { m_Rows[0][x], m_Rows[1][x], m_Rows[2][x], m_Rows[3][x] } };
  }

  std::array<const VertexId *, 4> m_Rows;
  std::int32_t                    m_Size;
  std::int32_t                    m_Y;
  std::int32_t                    m_Z;
};
} // namespace

BlockCells
DifferentCells(const std::array<VertexId, 8> & voxels)
{
  BlockCells different{ {}, 0 };
  for (const VertexId v : voxels)
  {
    int at = different.count;
    while (at > 0 && different.cells[at - 1] > v)
    {
      --at;
    }
    if (at > 0 && different.cells[at - 1] == v)
    {
      continue;
    }
    std::copy_backward(different.cells.begin() + at,
                       different.cells.begin() + different.count,
                       different.cells.begin() + different.count + 1);
    different.cells[at] = v;
    ++different.count;
  }
  return different;
}

std::vector<CrowdedBlock>
FindCrowdedBlocks(const LabelVolume & volume, const Execution & execution)
{
  const std::vector<VertexId>            outside(static_cast<std::size_t>(volume.size[0]), ExteriorVertex);
  std::vector<std::vector<CrowdedBlock>> ofPlane(static_cast<std::size_t>(volume.size[2]) + 1);
  execution.For(ofPlane.size(), [&](std::size_t plane) {
    for (std::int32_t y = -1; y < volume.size[1]; ++y)
    {
      BlockRow(volume, outside, y, static_cast<std::int32_t>(plane) - 1).Append(ofPlane[plane]);
    }
  });
  std::vector<CrowdedBlock> blocks;
  for (const auto & plane : ofPlane)
  {
    blocks.insert(blocks.end(), plane.begin(), plane.end());
  }
  return blocks;
}
} // namespace tissue
