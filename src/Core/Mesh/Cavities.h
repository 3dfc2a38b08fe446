/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Cavities_h
#define TissueTessellationCore_Cavities_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** Returns for each hole of exterior in a single cell that cell, in the order of the walls: a wall of a cell and the
 * exterior that is closed, with the exterior within it. */
std::vector<VertexId>
FindCavities(const WallMesh & mesh);
} // namespace tissue

#endif
