/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_JunctionLookup_h
#define TissueTessellationCore_JunctionLookup_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"

namespace tissue
{
/** The wall of two cells, given in any order; nullptr where the image has none. */
const Wall *
FindWall(const JunctionSet & junctions, VertexPair cells);

/** The junction of four cells, given in any order; nullptr where the image has none. */
const Junction *
FindJunction(const JunctionSet & junctions, VertexQuadruple cells);
} // namespace tissue

#endif
