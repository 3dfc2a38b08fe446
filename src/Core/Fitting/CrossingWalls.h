/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CrossingWalls_h
#define TissueTessellationCore_CrossingWalls_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** Which points of walls that cross are smoothed. */
enum class SmoothedPoints
{
  /** All within the walls: where these are far from the image anyway, as those of stars. */
  WholeWalls,
  /** Those of the triangles that cross, next those around them, too: what is near to the image stays there. */
  AroundCrossings
};

/** \brief Frees a mesh of the crossings that remeshing made.
 *
 * Of walls that cross, as few as part all pairs are smoothed, which unfolds a wall; a wall may also cross itself. Those
 * that still cross get their triangles of `old` back. The two meshes must agree in their points on lines and at
 * corners, which come first in both, as RemeshWalls() leaves them; these points stay. Nothing crosses afterwards where
 * nothing did in `old`.
 *
 * \return the number of walls that are as in `old` again. */
std::int64_t
MendCrossingWalls(WallMesh & mesh, const WallMesh & old, SmoothedPoints smoothed,
                  const Execution & execution = Execution());
} // namespace tissue

#endif
