/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Untangling_h
#define TissueTessellationCore_Untangling_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief Moves the points of crossing triangles until none cross, by a local search: of some places towards its
 * neighbours' mean and some at random, each point takes the one where its triangles cross the fewest others.
 *
 * It is meant for a mesh of few crossings, such as a fitted star. The result is deterministic. Returns the number of
 * pairs that still cross after `maximumSweeps`, which is 0 except in hopeless cases. */
std::int64_t
Untangle(WallMesh & mesh, int maximumSweeps, const Execution & execution = Execution());
} // namespace tissue

#endif
