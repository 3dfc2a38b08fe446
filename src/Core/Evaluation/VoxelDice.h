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
/** \brief Computes for each vertex the Dice index of its voxels in the image and of the voxels whose centres are within
 * its surface in the mesh: 2 |A & B| / (|A| + |B|), in 0 .. 1.
 *
 * Along each row of voxels a centre is within the surface where an odd number of triangles has been passed. A centre on
 * a wall is within one of the wall's two cells. The index is 0 for a cell that has no triangle or no voxel, and for the
 * exterior. Only voxels of the image count, not what the mesh has outside of it. Vertices of `walls` from
 * `numberOfVertices` on are not cells. The time is proportional to the triangles and the rows that each of them spans.
 */
std::vector<double>
ComputeVoxelDice(const WallMesh & walls, VertexId numberOfVertices, const LabelVolume & labels,
                 const Execution & execution = Execution());
} // namespace tissue

#endif
