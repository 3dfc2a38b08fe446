/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CavityVolumes_h
#define TissueTessellationCore_CavityVolumes_h

#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief The cavities of cells, as if each were a cell: without a volume of its own a cavity and the outside of its
 * cell might shrink or grow together. */
struct CavityVolumes
{
  /** For each wall, the cavity that its exterior is: a vertex after those of the cells; else ExteriorVertex. */
  std::vector<VertexId> ofWall;
  /** The volume in the image of each cavity, of the first one first. */
  std::vector<double> volumes;
  /** The cells of voids of the image that are no cavity of the mesh, ascending, one for each void. */
  std::vector<VertexId> cellsOfFilledVoids;
};

/** \brief Finds the cavities (FindCavities()) and gives them the volumes of the voids of the image.
 *
 * A void is the cavity's of the same cell whose box, wider by a voxel on all sides, has its first voxel; of several the
 * smallest. The volume of a cavity without a void is 0.
 * \param cells the image by the vertices of the cells, of which there are `numberOfVertices`, the exterior included. */
CavityVolumes
FindCavityVolumes(const WallMesh & mesh, std::size_t numberOfVertices, const LabelVolume & cells);
} // namespace tissue

#endif
