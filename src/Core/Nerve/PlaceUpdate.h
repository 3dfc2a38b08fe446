/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PlaceUpdate_h
#define TissueTessellationCore_PlaceUpdate_h

#include "Nerve/TissuePlaces.h"

namespace tissue
{
/** A voxel that has another vertex than before. */
struct VoxelChange
{
  VoxelIndex voxel;
  VertexId   before;
};

/** Makes the crowded blocks of an image those that it has now that voxels of it have changed: what FindCrowdedBlocks()
 * finds, at the cost of the changes. */
void
UpdateCrowdedBlocks(const LabelVolume & volume, const std::vector<VoxelChange> & changes,
                    std::vector<CrowdedBlock> & blocks);

/** Makes the walls of an image those that it has now that voxels of it have changed: what FindImageWalls() finds, at
 * the cost of the walls concerned.
 *
 * \param changes of a voxel that is there several times the first one tells what it was. */
void
UpdateImageWalls(const LabelVolume & volume, const std::vector<VoxelChange> & changes, std::vector<ImageWall> & walls);
} // namespace tissue

#endif
