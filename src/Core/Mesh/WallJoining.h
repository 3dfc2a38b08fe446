/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallJoining_h
#define TissueTessellationCore_WallJoining_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** Joins walls of the same two cells that meet along edges of no third wall, and counts the cells at points anew. What
 * comes of it need not be a disk. Walls keep the order of their first parts, triangles that within their walls; points
 * stay. */
void
JoinWalls(WallMesh & mesh);
} // namespace tissue

#endif
