/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/VoxelBox.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** Extends the boxes by the vertices of all voxels, from the first one on. */
template <typename TVertex>
void
AddVoxels(const VoxelIndex & size, const TVertex * row, std::vector<VoxelBox> & boxes)
{
  for (std::int32_t z = 0; z < size[2]; ++z)
  {
    for (std::int32_t y = 0; y < size[1]; ++y, row += size[0])
    {
      for (std::int32_t begin = 0; begin < size[0];)
      {
        const TVertex vertex = row[begin];
        const auto    end = std::find_if(row + begin, row + size[0], [=](TVertex v) { return v != vertex; });
        VoxelBox &    box = boxes[static_cast<std::size_t>(vertex)];
        box.Add({ { begin, y, z } });
        begin = static_cast<std::int32_t>(end - row);
        box.Add({ { begin - 1, y, z } });
      }
    }
  }
}
} // namespace

std::vector<VoxelBox>
FindVoxelBoxes(const LabelVolume & volume, std::size_t numberOfVertices)
{
  std::vector<VoxelBox> boxes(numberOfVertices);
  volume.vertices.Visit([&](const auto * first) { AddVoxels(volume.size, first, boxes); });
  return boxes;
}
} // namespace tissue
