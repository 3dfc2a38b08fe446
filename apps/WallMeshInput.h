/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef WallMeshInput_h
#define WallMeshInput_h

#include "TissueTessellationCore/JunctionSet.h"
#include "TissueTessellationCore/WallMesh.h"

#include <string>

namespace tissue
{
/** \brief Reads a wall mesh of any origin: a .vtp or .vtk file of triangles with an integer cell array of the two
 * labels on each one's sides, the normal pointing from the first to the second.
 *
 * Labels become vertices of `junctions`. WallMesh::numberOfCells stays empty. Triangles are neighbours where they share
 * points; equal points are not joined.
 * \throws std::runtime_error: no such file, not readable, no triangles, other polygons, no such array or not of two
 * components, a point that is not finite, a label that is neither a cell's nor the exterior's, the same label twice. */
WallMesh
ReadWallMesh(const std::string & path, const std::string & labelArray, const JunctionSet & junctions);
} // namespace tissue

#endif
