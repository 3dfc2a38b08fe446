/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_KuhnFragments_h
#define TissueTessellationCore_KuhnFragments_h

#include "TissueTessellationCore/Image/LabelVolume.h"

#include <vector>

namespace tissue
{
/** A piece of a cell that is not its largest one, and the cell or exterior that has got its voxels. */
struct AbsorbedFragment
{
  VertexId     cell;
  VertexId     into;
  std::int64_t numberOfVoxels;
};

/** \brief Makes every cell one piece in the Kuhn subdivision of the grid, in which a cell of several pieces would have
 * a split link.
 *
 * Voxels are neighbours there where a step of 0 or 1 along each axis leads from one to the other: face neighbours, and
 * some by edges and corners, so fewer pieces are fragments than by faces. Each cell keeps its largest piece, of several
 * the first in raster order. Its other pieces go to the cell or exterior of the most common faces among those pieces
 * that stay, of several to that of the least vertex; a fragment that touches fragments alone goes where they have gone.
 * The exterior may have any number of pieces. */
std::vector<AbsorbedFragment>
AbsorbFragments(LabelVolume & volume, VertexId numberOfVertices);
} // namespace tissue

#endif
