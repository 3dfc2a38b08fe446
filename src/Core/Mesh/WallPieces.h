/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallPieces_h
#define TissueTessellationCore_WallPieces_h

#include "Mesh/WallPatch.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief The triangles of one wall, with the numbers of its own points: first those of its outline. */
struct WallPiece
{
  /** The points of the mesh on the wall's outline, in ascending order. */
  std::vector<PointId> outline;
  /** The positions of the points within the wall. */
  std::vector<Point>                       interior;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

/** The triangles of each wall in WallMesh::triangles: [first[w], first[w + 1]).
 * \throws std::invalid_argument where those of a wall are not consecutive, or the walls not in their order. */
std::vector<std::size_t>
FirstTrianglesOfWalls(const WallMesh & mesh);

WallPiece
CutOutWall(const WallMesh & mesh, std::size_t firstTriangle, std::size_t endTriangle);

/** The piece of a wall of `mesh` with positions, to be changed; its points keep their numbers. */
WallPatch
MakePatch(const WallMesh & mesh, const WallPiece & piece);

/** Gives the piece the triangles of a compact patch and the points within it. */
void
TakePatch(const WallPatch & patch, WallPiece & piece);

/** Puts the pieces in the place of the walls of `mesh`. Its points on lines and at corners remain, and come first. */
WallMesh
JoinWallPieces(const WallMesh & mesh, const std::vector<WallPiece> & pieces);
} // namespace tissue

#endif
