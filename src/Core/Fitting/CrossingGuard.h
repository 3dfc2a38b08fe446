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

/** \brief Takes back so much of a move of the mesh's points that it makes no triangles cross.
 *
 * `before` has the points before the move. `shares` descend to 0. As long as triangles cross, or fold onto a neighbour,
 * their points go back to the next of these shares of their way. A mesh without crossings thus stays so. Returns the
 * number of points that stepped back. */
std::int64_t
StepBackFromCrossings(WallMesh & mesh, const std::vector<Point> & before, const std::vector<double> & shares,
                      const Execution & execution = Execution());
} // namespace tissue

#endif
