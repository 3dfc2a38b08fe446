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
/** \brief The same mesh with its walls, and their triangles, in another order: by the rank of a wall's first cell, then
 * of its second.
 *
 * With ranks along a curve through the cells (SpatialOrder()), what is near in the tissue is near in memory: work on
 * the walls one after another then takes as long a wall in a large tissue as in a small one. `ranks` has one for each
 * vertex of the adjacency complex. \throws std::invalid_argument where a wall's cell has none. */
WallMesh
OrderWalls(const WallMesh & mesh, const std::vector<VertexId> & ranks);

/** The points by the first triangle that has them, those of corners and lines before those within walls, and none that
 * no triangle has: for TakePoints() (PointNumbering.h). */
std::vector<PointId>
PointsByTriangles(const WallMesh & mesh);

/** Gives the mesh its points in this order; those not in it, which no triangle may have, go. */
void
TakePoints(WallMesh & mesh, const std::vector<PointId> & order);

/** Puts the points on lines and at corners before those within walls, each in their order; those of no triangle go. */
void
PutLinePointsFirst(WallMesh & mesh);
} // namespace tissue

#endif
