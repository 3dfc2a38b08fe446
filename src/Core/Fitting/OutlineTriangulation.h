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
/** \brief Gives walls that are far from their place in the image other triangles, which have the points of their
 * outline alone and follow the image.
 *
 * Where a wall is bent round a corner, or winds between its neighbours, its star has its centre, and most of its area,
 * off the wall; its outline still is in place. Of the triangulations of the outline the one of the least cost follows
 * the image, the cost being each triangle's area times 1 + the mean square of its edges' distances, in tolerances, from
 * their midpoints to the faces. No new edge joins two points that another wall has too. A wall is far where its
 * triangles' centroids, weighted by area, are on average farther than `tolerance` from the nearest face.
 *
 * Points on lines and at corners stay as they are and come first, as RemeshWalls() leaves them. Walls without faces, or
 * whose outline has no triangulation, stay as they are. The time is O(n^3) for n points of a far wall's outline.
 *
 * \param faces the faces of each wall of the mesh.
 * \param tolerance the length of an edge of the wanted triangles, in physical units; positive.
 * \return the walls that are new, ascending. */
std::vector<WallId>
TriangulateFarOutlines(WallMesh & mesh, const ImagePlaces & faces, double tolerance,
                       const Execution & execution = Execution());
} // namespace tissue

#endif
