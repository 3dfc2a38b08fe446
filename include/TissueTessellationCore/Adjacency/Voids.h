/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Voids_h
#define TissueTessellationCore_Voids_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <vector>

namespace tissue
{
/** The junctions with the voids counted to the exterior, as in the paper (section 3.3), which has one exterior vertex:
 * walls, lines and junctions of a void are the exterior's. Numbers of blocks are upper bounds, as a block that sees
 * two of them counted for each. A junction at several of them has the position of the one with most blocks. */
JunctionSet
MergeVoids(const JunctionSet & junctions);

/** Likewise, but a void stays what it is for the cells that enclose it: it is the exterior for the cells of the other
 * parts of the tissue, which lie within it. `partOfVertex` has the part of every cell and of every void. */
JunctionSet
MergeVoidsOfOtherParts(const JunctionSet & junctions, const std::vector<int> & partOfVertex);

} // namespace tissue

#endif
