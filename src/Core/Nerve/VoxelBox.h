/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_VoxelBox_h
#define TissueTessellationCore_VoxelBox_h

#include "Nerve/KuhnSimplex.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

#include <algorithm>
#include <limits>

namespace tissue
{
/** The least box around voxels, both ends in it. */
struct VoxelBox
{
  static constexpr std::int32_t Limit = std::numeric_limits<std::int32_t>::max();

  VoxelIndex least = { { Limit, Limit, Limit } };
  VoxelIndex most = { { -Limit, -Limit, -Limit } };

  bool
  IsEmpty() const
  {
    return least[0] > most[0];
  }

  void
  Add(const VoxelIndex & p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      least[axis] = std::min(least[axis], p[axis]);
      most[axis] = std::max(most[axis], p[axis]);
    }
  }

  std::int64_t
  NumberOfVoxels() const
  {
    return this->IsEmpty()
             ? 0
             : std::int64_t{ most[0] - least[0] + 1 } * (most[1] - least[1] + 1) * (most[2] - least[2] + 1);
  }
};

/** The box of the voxels of each of the vertices 0 ... numberOfVertices - 1; the image is read once. */
std::vector<VoxelBox>
FindVoxelBoxes(const LabelVolume & volume, std::size_t numberOfVertices);
} // namespace tissue

#endif
