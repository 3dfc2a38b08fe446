/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallMeshOrder_h
#define TissueTessellationCore_WallMeshOrder_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** Gives the mesh its points in this order; those not in it, which no triangle may have, go. */
void
TakePoints(WallMesh & mesh, const std::vector<PointId> & order);

/** Puts the points on lines and at corners before those within walls, each in their order; those of no triangle go. */
void
PutLinePointsFirst(WallMesh & mesh);
} // namespace tissue

#endif
