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
/** Lists the points in the order of the first triangle that has each of them, for TakePoints(). Those at corners and on
 * lines come before those within walls; points that no triangle has are left out. */
std::vector<PointId>
PointsByTriangles(const WallMesh & mesh);

/** Numbers the points of the mesh anew, in this order. Points that are not in it are dropped; no triangle may have one.
 */
void
TakePoints(WallMesh & mesh, const std::vector<PointId> & order);

/** Puts the points on lines and at corners before those within walls. Both keep their order; points that no triangle
 * has are dropped. */
void
PutLinePointsFirst(WallMesh & mesh);
} // namespace tissue

#endif
