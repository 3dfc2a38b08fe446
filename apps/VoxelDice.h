/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef VoxelDice_h
#define VoxelDice_h

#include "TissueTessellationCore/LabelVolume.h"
#include "TissueTessellationCore/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief Of each vertex the Dice index of its voxels in the image and of the voxels whose centres are within its
 * surface in the mesh (vtkPolyDataToImageStencil): 2 |A & B| / (|A| + |B|), in 0 .. 1.
 *
 * 0 for a cell that has no triangle, or is in no voxel. Voxels of the image alone: what the mesh has outside counts
 * not. The entry of the exterior is 0. */
std::vector<double>
ComputeVoxelDice(const WallMesh & walls, VertexId numberOfVertices, const LabelVolume & labels);
} // namespace tissue

#endif
