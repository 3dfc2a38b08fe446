/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_GatherJunctions_h
#define TissueTessellationCore_GatherJunctions_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Image/BlockScan.h"

#include <vector>

namespace tissue
{
/** Joins the scans of an image. They must be of consecutive planes, and together of the planes 1 ... size[2] + 1.
 *
 * \param size the image's size in voxels.
 * \param spacing the edges of a voxel, for volumes and areas.
 * \param exterior the labels the scans took for the exterior. The exterior vertex gets its label; where no label is the
 * exterior's, it gets one that no cell has, the first free one of 0, -1, -2, ...
 * \return the junction set. Its points are continuous indices of the image, whose first voxel is (0, 0, 0). */
JunctionSet
GatherJunctions(const std::vector<const BlockScan *> & scans, const BlockScan::Index & size, const Point & spacing,
                const ExteriorLabels & exterior);

} // namespace tissue

#endif
