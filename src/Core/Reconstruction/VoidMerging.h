/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_VoidMerging_h
#define TissueTessellationCore_VoidMerging_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** Tetrahedra with the voids' vertices replaced by the exterior's; those with two of either are left out. */
std::vector<VertexQuadruple>
MergeVoids(const std::vector<VertexQuadruple> & tetrahedra, const JunctionSet & junctions);

/** The walls with the voids replaced by the exterior. A wall between two of either, which the image never has, is left
 * out, with the points that it alone has. A cell may then have several walls to the exterior. */
void
MergeVoids(WallMesh & walls, const JunctionSet & junctions);
} // namespace tissue

#endif
