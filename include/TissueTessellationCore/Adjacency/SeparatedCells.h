/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SeparatedCells_h
#define TissueTessellationCore_SeparatedCells_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <vector>

namespace tissue
{
/** The cells that have no wall to another cell though another one is near: the sign of a segmentation whose cells are
 * eroded, with walls of background between them. Near: the distance of the centres is at most reach times the sum of
 * the radii of the balls of the cells' volumes. In ascending order, without the exterior. */
std::vector<VertexId>
FindSeparatedCells(const JunctionSet & junctions, double reach = 1.5);
} // namespace tissue

#endif
