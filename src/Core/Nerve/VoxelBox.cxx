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
std::vector<VoxelBox>
FindVoxelBoxes(const LabelVolume & volume, std::size_t numberOfVertices)
{
  std::vector<VoxelBox> boxes(numberOfVertices);
  const VertexId *      row = volume.vertices.data();
  for (std::int32_t z = 0; z < volume.size[2]; ++z)
  {
    for (std::int32_t y = 0; y < volume.size[1]; ++y, row += volume.size[0])
    {
      for (std::int32_t begin = 0; begin < volume.size[0];)
      {
        const VertexId vertex = row[begin];
        const auto     end = std::find_if(row + begin, row + volume.size[0], [=](VertexId v) { return v != vertex; });
        VoxelBox &     box = boxes[static_cast<std::size_t>(vertex)];
        box.Add({ { begin, y, z } });
        begin = static_cast<std::int32_t>(end - row);
        box.Add({ { begin - 1, y, z } });
      }
    }
  }
  return boxes;
}
} // namespace tissue
