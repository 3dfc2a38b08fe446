/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_VertexRestoration_h
#define TissueTessellationCore_VertexRestoration_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** Tetrahedra under numbers by the vertices of the numbers: order[i] of i (SpatialNumbering). As
 * AdjacencyComplex::GetTetrahedra() gives them. */
std::vector<VertexQuadruple>
RestoreVertices(std::vector<VertexQuadruple> tetrahedra, const std::vector<VertexId> & order);

/** Likewise the walls of the dual of the tetrahedra, whose first points are the corners in the order of the tetrahedra.
 * Corners come to be in the order of the restored tetrahedra, and the cells of each wall in WallMesh's order, for which
 * its triangles are turned over if need be; else points, triangles and walls stay where they are. */
void
RestoreVertices(WallMesh & walls, const std::vector<VertexQuadruple> & tetrahedra, const std::vector<VertexId> & order);
} // namespace tissue

#endif
