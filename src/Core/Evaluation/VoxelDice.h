/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_VoxelDice_h
#define TissueTessellationCore_VoxelDice_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief Of each vertex the Dice index of its voxels in the image and of the voxels whose centres are within its
 * surface in the mesh: 2 |A & B| / (|A| + |B|), in 0 .. 1.
 *
 * Along each row of voxels a centre is within where an odd number of triangles has been passed; one on a wall is within
 * one of the wall's two cells. 0 for a cell that has no triangle, or is in no voxel. Voxels of the image alone: what
 * the mesh has outside counts not. The entry of the exterior is 0. Vertices of `walls` from `numberOfVertices` on are
 * no cells. Time: in proportion to the triangles and the rows that each spans. */
std::vector<double>
ComputeVoxelDice(const WallMesh & walls, VertexId numberOfVertices, const LabelVolume & labels,
                 const Execution & execution = Execution());
} // namespace tissue

#endif
