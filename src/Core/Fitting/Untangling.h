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
/** \brief Moves the points of crossing triangles until none cross, by a local search: each point takes the place, of a
 * few about its neighbours' mean and at random, where its triangles cross the fewest others.
 *
 * For a mesh of few crossings (a fitted star). Deterministic. Returns the pairs that still cross after
 * `maximumSweeps`: 0 but for hopeless cases. */
std::int64_t
Untangle(WallMesh & mesh, int maximumSweeps, const Execution & execution = Execution());
} // namespace tissue

#endif
