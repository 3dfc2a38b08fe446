/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallRemeshing_h
#define TissueTessellationCore_WallRemeshing_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief Remeshes each wall within its outline, to triangles of the wall's edge length (WallEdgeLengths.h) that are as
 * nearly equilateral as the outline allows.
 *
 * Points of lines and corners, and the edges between neighbours on a line, stay as they are. These points keep their
 * order and come before all points within walls. The new points of a wall lie on its old triangles, so that a curved
 * wall stays curved. Every wall is a disk before and after. No new edge joins two points that are both in another wall
 * too, as two points of one line are. Where the old triangles are folded, a wall can keep more points than wanted.
 *
 * Walls do not depend on each other. `mesh` needs its numberOfCells, and walls that have no edge twice in their
 * outline: a wall of two corners needs points on its lines.
 * \throws std::invalid_argument unless there is one length for each wall, all lengths are positive, and the triangles
 * of a wall are consecutive. */
void
RemeshWalls(WallMesh & mesh, const std::vector<double> & edgeLengths, const Execution & execution = Execution());

/** \brief Splits the longest edges within each wall at their middles until it has as many points as RemeshWalls() would
 * give it.
 *
 * The surface stays as it is, so that a mesh that does not cross itself still does not. In all else this is like
 * RemeshWalls(). */
void
SubdivideWalls(WallMesh & mesh, const std::vector<double> & edgeLengths, const Execution & execution = Execution());

/** \brief Calls SubdivideLines() and RemeshWalls() for a wanted number of triangles in all; returns the edge lengths.
 *
 * The lengths are those that ChooseEdgeLengths() gives for these factors, corrected at most twice until the number is
 * within 2 % of the wanted one. A number below what the outlines need is not reached. */
std::vector<double>
RemeshToNumberOfTriangles(WallMesh & mesh, double numberOfTriangles, const std::vector<double> & factors = {},
                          const Execution & execution = Execution());

/** \brief Puts the triangles of `other` in the place of those of some walls.
 *
 * The two meshes must agree in their points on lines and at corners, which must come first in both, as RemeshWalls()
 * leaves them. They come first in the result, too. */
void
ReplaceWalls(WallMesh & mesh, const WallMesh & other, const std::vector<WallId> & walls);
} // namespace tissue

#endif
