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
/** \brief Gives the same mesh with its walls, and their triangles, in another order: by the rank of a wall's first
 * cell, then by that of its second.
 *
 * With ranks along a curve through the cells (SpatialOrder()), what is near in the tissue is near in memory. Work on
 * the walls one after another then takes no longer for a wall of a large tissue than for one of a small tissue. `ranks`
 * has a rank for each vertex of the adjacency complex. \throws std::invalid_argument where a wall's cell has none. */
WallMesh
OrderWalls(const WallMesh & mesh, const std::vector<VertexId> & ranks);

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
