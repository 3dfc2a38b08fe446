/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallMeasures_h
#define TissueTessellationCore_WallMeasures_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <cstddef>
#include <vector>

namespace tissue
{
/** The area of all triangles, in squared units. */
double
ComputeArea(const WallMesh & mesh);

/** The area of each wall. */
std::vector<double>
ComputeWallAreas(const WallMesh & mesh);

/** The volume of each cell within its walls, by vertex, in cubed units; that of the exterior is 0. */
std::vector<double>
ComputeVolumes(const WallMesh & mesh, std::size_t numberOfVertices);
} // namespace tissue

#endif
