/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallRefinement_h
#define TissueTessellationCore_WallRefinement_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief Splits every triangle into four at the middles of its edges (paper, section 4.2). Shared edges are split
 * once, so the walls stay joined. The first points are the old ones, in their order. */
void
SplitTriangles(WallMesh & mesh);

/** \brief Smooths the walls in place by Taubin's filter (G. Taubin, A signal processing approach to fair surface
 * design, SIGGRAPH 1995, doi:10.1145/218380.218473), which does not shrink them. In each iteration a point goes by 0.5
 * of its distance towards the mean of its neighbours, and then by 0.53 of its new distance away from it.
 *
 * Points within a wall follow all their neighbours, points on a triple line their two neighbours on it; junctions stay
 * where they are. */
void
SmoothWalls(WallMesh & mesh, int numberOfIterations);
} // namespace tissue

#endif
