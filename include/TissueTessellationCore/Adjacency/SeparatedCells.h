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
/** Returns the cells that have no wall to another cell though another one is near, in ascending order, without the
 * exterior: they are the sign of a segmentation whose cells are eroded, with walls of background between them.
 *
 * Two cells are near where the distance of their centres is at most `reach` times the sum of their radii, those of the
 * balls of their volumes. Balls that touch have the ratio 1; a larger reach leaves room for the eroded wall and for
 * cells that are no balls. */
std::vector<VertexId>
FindSeparatedCells(const JunctionSet & junctions, double reach = 1.5);
} // namespace tissue

#endif
