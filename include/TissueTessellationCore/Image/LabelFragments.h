/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LabelFragments_h
#define TissueTessellationCore_LabelFragments_h

#include "TissueTessellationCore/Common/Types.h"

#include <cstddef>
#include <vector>

namespace tissue
{
/** The consecutive voxels [begin, end) of one label in a row of the image. */
struct LabelRun
{
  Label        label;
  std::int32_t begin;
  std::int32_t end;
};

/** \brief A label image as the runs of its rows.
 *
 * The rows are in raster order (the second axis fastest), the runs of a row go from left to right without gaps.
 * Adjacent runs of a row may be of the same label. */
struct LabelRuns
{
  /** The number of rows along the second axis, which make up a layer. The total number of rows tells how many layers
   * there are. */
  std::size_t           rowsPerLayer = 1;
  std::vector<LabelRun> runs;
  /** For each row the index after its last run. */
  std::vector<std::size_t> endOfRow;
};

/** \brief Makes every cell one piece that is connected by faces of voxels.
 *
 * Each cell keeps its largest piece; of equally large ones it keeps the first in raster order. Each of its other pieces
 * goes to the cell, or the exterior, with which it has the most faces in common; of equals to that of the least label.
 * The exterior keeps all pieces that touch the image's border, and loses its voids. The function changes the labels of
 * the runs, and returns the number of voxels changed. */
std::int64_t
MergeFragments(LabelRuns & labels, Label exterior);
} // namespace tissue

#endif
