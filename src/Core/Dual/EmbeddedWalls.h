/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_EmbeddedWalls_h
#define TissueTessellationCore_EmbeddedWalls_h

#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** The walls of an image just as it has them. */
struct EmbeddedWalls
{
  WallMesh mesh;
  /** The cells of each corner, as AdjacencyComplex::GetTetrahedra() has them; the corners are the mesh's first points.
   */
  std::vector<VertexQuadruple> tetrahedra;
};

/** \brief Makes the walls of a label image that lie in it, whatever the image is like: the faces between the voxels'
 * parts of the Kuhn subdivision of the grid (KuhnSimplex.h).
 *
 * Of each tetrahedron a voxel has the part where its barycentric coordinate is the largest, of all together just its
 * volume. So each cell has the volume of its voxels, no two triangles cross, no more than four cells meet, and every
 * surface is closed: a sphere for each piece of a cell without handles. The price is roughness, and some dozen
 * triangles for each voxel at a wall. Walls are connected pieces, which need be no disks; they are ascending by their
 * cells.
 *
 * \param volume by vertices; the exterior is ExteriorVertex, as is all that is outside.
 * \param cellOf the cell of each vertex. Between vertices of one cell there are no walls. */
EmbeddedWalls
MakeEmbeddedWalls(const LabelVolume & volume, const std::vector<VertexId> & cellOf);

/** The most triangles that MakeEmbeddedWalls() can make, in a pass over the voxels. */
std::int64_t
CountEmbeddedTriangles(const LabelVolume & volume, const std::vector<VertexId> & cellOf);
} // namespace tissue

#endif
