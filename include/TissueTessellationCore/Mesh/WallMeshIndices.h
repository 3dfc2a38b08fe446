/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallMeshIndices_h
#define TissueTessellationCore_WallMeshIndices_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief Makes sure that a wall mesh of any origin can be read without reaching outside of its lists.
 *
 * `numberOfVertices` counts the cells and the exterior, so it is at least 1. WallMesh::numberOfCells may be empty.
 *
 * \throws std::invalid_argument otherwise: for lists of different lengths, for a point, wall or cell that is out of
 * range, and for a wall of a cell with itself. */
void
RequireConsistentIndices(const WallMesh & mesh, VertexId numberOfVertices);
} // namespace tissue

#endif
