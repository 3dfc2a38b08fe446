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
/** Numbers of pairs of crossing triangles. */
struct UntanglingCounts
{
  std::int64_t before = 0;
  std::int64_t after = 0;
};

/** Whether more pairs of triangles cross than there are triangles, as in the walls of an image of noise. */
bool
IsHopeless(std::int64_t crossingPairs, const WallMesh & mesh);

/** \brief Moves the points of crossing triangles until none cross, by a local search: of some places towards its
 * neighbours' mean and some at random, each point takes the one where its triangles cross the fewest others.
 *
 * It is meant for a mesh of few crossings, such as a fitted star; where that IsHopeless() the mesh stays as it is. The
 * result is deterministic. After `maximumSweeps`, or after looking at 16 million pairs of triangles, or 2000 for
 * each triangle of the mesh, no pairs cross, except in hopeless cases. */
UntanglingCounts
Untangle(WallMesh & mesh, int maximumSweeps, const Execution & execution = Execution());
} // namespace tissue

#endif
