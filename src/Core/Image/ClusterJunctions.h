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
/** Gives the junctions of the quadruples, in ascending order of their cells. The quadruples may come in any order;
 * their cells are vertices of the complex. Positions are continuous indices of the image. */
std::vector<Junction>
ClusterJunctions(std::vector<BlockScan::Quadruple> quadruples);
} // namespace tissue

#endif
