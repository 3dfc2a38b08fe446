/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CrossingGuard_h
#define TissueTessellationCore_CrossingGuard_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallAngles.h"

namespace tissue
{

/** \brief Takes back so much of a move of the mesh's points that it makes no triangles cross, and none too sharp.
 *
 * `before` has the points before the move. `shares` descend to 0. As long as triangles cross, or an angle of a triangle
 * or between two of them is below its limit and less than before, their points go back to the next of these shares of
 * their way. A mesh without crossings or sharp angles thus stays so; edges are not looked at. Returns the number of
 * points that stepped back. */
std::int64_t
StepBackFromCrossings(WallMesh & mesh, const std::vector<Point> & before, const std::vector<double> & shares,
                      const AngleLimits & angles, const Execution & execution = Execution());
} // namespace tissue

#endif
