/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_OutlineTriangulation_h
#define TissueTessellationCore_OutlineTriangulation_h

#include "Image/ImagePlaces.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief Gives walls that are far from their place in the image other triangles: of their outline's points alone,
 * along the image.
 *
 * A star of a wall that is bent round a corner, or winds between its neighbours, has its centre, and most of its area,
 * off the wall. Its outline does not: triangulated so that the area, times 1 + the mean square of its edges' distances
 * to the faces at their midpoints in tolerances, is least, it follows the image. No new edge joins two points that
 * another wall has too. A wall is far where its triangles' centroids are farther than `tolerance` from the nearest face
 * on average, weighted by area.
 *
 * Points on lines and at corners stay as they are and come first, as RemeshWalls() leaves them, and walls without
 * faces, or whose outline has no triangulation, as they are. Time O(n^3) for n points of a far wall's outline.
 *
 * \param faces the faces of each wall of the mesh.
 * \param tolerance in physical units, positive: what an edge of the wanted triangles spans.
 * \return the walls that are new, ascending. */
std::vector<WallId>
TriangulateFarOutlines(WallMesh & mesh, const ImagePlaces & faces, double tolerance,
                       const Execution & execution = Execution());
} // namespace tissue

#endif
