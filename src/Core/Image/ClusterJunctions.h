/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ClusterJunctions_h
#define TissueTessellationCore_ClusterJunctions_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Image/BlockScan.h"

#include <vector>

namespace tissue
{
/** The junctions of the given quadruples of cells (any order, as vertices of the complex), in ascending order;
 * positions as continuous indices. */
std::vector<Junction>
ClusterJunctions(std::vector<BlockScan::Quadruple> quadruples);
} // namespace tissue

#endif
