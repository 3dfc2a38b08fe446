/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SuspectLabels_h
#define SuspectLabels_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <vector>

namespace tissue
{
/** The labels of the cells that FindSuspectCells() names, ascending. */
std::vector<Label>
FindSuspectLabels(const JunctionSet & junctions);
} // namespace tissue

#endif
