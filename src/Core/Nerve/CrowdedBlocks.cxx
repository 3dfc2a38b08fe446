/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/CrowdedBlocks.h"

#include "Nerve/PlaneScan.h"

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
  CrowdedBlockGathering gathering(volume);
  VisitVariedBlocks(
    volume, [&](std::size_t slab, const CrowdedBlock & block) { gathering.Add(slab, block); }, execution);
  return gathering.TakeBlocks();
}
} // namespace tissue
