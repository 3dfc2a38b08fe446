/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallFittingStatistics_h
#define TissueTessellationCore_WallFittingStatistics_h

#include "TissueTessellationCore/Mesh/WallAngles.h"

#include <cstdint>
#include <vector>

namespace tissue
{
/** \brief How the fit of the walls went. */
struct WallFittingStatistics
{
  /** The number of corners whose four cells do not meet in the image, or not near the corner. */
  std::int64_t unfittedCorners = 0;
  /** The number of unfitted corners of each cell. */
  std::vector<std::int32_t> unfittedCornersOfCell;
  /** The cells of holes in the image that the mesh does not have, ascending, one for each hole. */
  std::vector<VertexId> cellsOfFilledVoids;
  /** The pairs of triangles of the first star that crossed and were parted. */
  std::int64_t untangledPairs = 0;
  /** The pairs of triangles that cross in the mesh, fitted or not, as no search could part them. */
  std::int64_t crossingPairs = 0;
  /** The number of walls that stay a subdivided star or outline at first, as they would cross others if remeshed. */
  std::int64_t starWalls = 0;
  /** Whether the walls are those of the voxels (EmbeddedWalls.h), as fitted ones crossed or turned cells inside out. */
  bool isEmbedded = false;
  /** The cells with crossing triangles, ascending, one for each pair of these; where the walls are those of the voxels,
   * the cells for which they are: so with fitted walls, or inside out. */
  std::vector<VertexId> cellsNotFitted;
  /** The places of the mesh that are sharper than AngleLimits and could not be mended. */
  std::vector<SharpPlace> sharpPlaces;
};

} // namespace tissue

#endif
