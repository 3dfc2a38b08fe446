/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/SuspectLabels.h"

#include "TissueTessellationCore/Adjacency/SuspectCells.h"

namespace tissue
{
std::vector<Label>
FindSuspectLabels(const JunctionSet & junctions)
{
  std::vector<Label> labels;
  for (const SuspectCell & suspect : FindSuspectCells(junctions))
  {
    labels.push_back(junctions.cells[suspect.cell].label);
  }
  return labels;
}
} // namespace tissue
