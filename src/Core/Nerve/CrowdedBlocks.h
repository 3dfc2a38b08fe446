/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CrowdedBlocks_h
#define TissueTessellationCore_CrowdedBlocks_h

#include "Image/BlockRow.h"
#include "Nerve/KuhnSimplex.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

#include <vector>

namespace tissue
{
/** A 2x2x2 block of voxels that holds four or more cells: where cells meet in corners. */
struct CrowdedBlock
{
  /** The block's first voxel, -1 in front of the image. */
  VoxelIndex  base;
  BlockVoxels cells;
};

/** Whether a block holds four different cells or more. */
bool
IsCrowded(const BlockVoxels & voxels);

/** All of them, in raster order (first axis fastest), those at the image's border included: outside is exterior.
 * Slabs of planes are read in parallel; the cost is that of reading the image once, the memory that of the blocks. */
std::vector<CrowdedBlock>
FindCrowdedBlocks(const LabelVolume & volume, const Execution & execution = Execution());

/** The different cells of a block, ascending. */
struct BlockCells
{
  std::array<VertexId, 8> cells;
  int                     count;
};

BlockCells
DifferentCells(const BlockVoxels & voxels);
} // namespace tissue

#endif
