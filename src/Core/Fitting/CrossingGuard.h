/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CrossingGuard_h
#define TissueTessellationCore_CrossingGuard_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{

/** \brief Takes back as much of a move of the mesh's points as makes triangles cross.
 *
 * `before` are the points before the move. The points of triangles that cross, or that fold onto a neighbour, and did
 * not before, go back to the next of `shares` of their way, which descend to 0, until there are none: a mesh without
 * crossings stays so. Returns the number of points that stepped back. */
std::int64_t
StepBackFromCrossings(WallMesh & mesh, const std::vector<Point> & before, const std::vector<double> & shares,
                      const Execution & execution = Execution());
} // namespace tissue

#endif
