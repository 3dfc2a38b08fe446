/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LabelPieces_h
#define TissueTessellationCore_LabelPieces_h

#include "TissueTessellationCore/Common/Types.h"

#include <cstddef>
#include <vector>

namespace tissue
{
/** Consecutive voxels of one label in a row of the image, [begin, end). */
struct LabelRun
{
  Label        label;
  std::int32_t begin;
  std::int32_t end;
};

/** \brief A label image as the runs of its rows.
 *
 * Rows in raster order (second axis fastest), the runs of a row from left to right without gaps. Adjacent runs of a row
 * may be of the same label. */
struct LabelRuns
{
  /** Rows along the second axis; there are as many of these layers as the number of rows tells. */
  std::size_t           rowsPerLayer = 1;
  std::vector<LabelRun> runs;
  /** The end of each row's runs. */
  std::vector<std::size_t> endOfRow;
};

/** \brief Makes every cell one piece, by the voxels' faces.
 *
 * Each cell keeps its largest piece, of several the first in raster order. Its other pieces go to the neighbouring cell
 * or exterior of the most common faces, of several to that of the least label. The exterior keeps all pieces that touch
 * the image's border, and loses its voids. Changes the labels of the runs, and returns the number of voxels changed. */
std::int64_t
MergeFragments(LabelRuns & labels, Label exterior);
} // namespace tissue

#endif
