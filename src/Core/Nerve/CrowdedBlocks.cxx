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
bool
IsCrowded(const BlockVoxels & voxels)
{
  std::array<VertexId, 3> found{ { voxels[0], voxels[0], voxels[0] } };
  int                     count = 1;
  for (const VertexId v : voxels)
  {
    if (v == found[0] || v == found[1] || v == found[2])
    {
      continue;
    }
    if (count == 3)
    {
      return true;
    }
    found[count++] = v;
  }
  return false;
}

BlockCells
DifferentCells(const BlockVoxels & voxels)
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
  std::vector<std::vector<CrowdedBlock>> ofPlane(static_cast<std::size_t>(volume.size[2]) + 1);
  execution.For(ofPlane.size(), [&](std::size_t plane) {
    const auto z = static_cast<std::int32_t>(plane) - 1;
    VisitMixedBlocks(volume, z, [&](std::int32_t x, std::int32_t y, const BlockVoxels & voxels) {
      if (IsCrowded(voxels))
      {
        ofPlane[plane].push_back({ { { x, y, z } }, voxels });
      }
    });
  });
  std::vector<CrowdedBlock> blocks;
  for (const auto & plane : ofPlane)
  {
    blocks.insert(blocks.end(), plane.begin(), plane.end());
  }
  return blocks;
}
} // namespace tissue
