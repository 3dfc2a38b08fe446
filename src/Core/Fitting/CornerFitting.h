/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CornerFitting_h
#define TissueTessellationCore_CornerFitting_h

#include "Dual/ImageDual.h"
#include "Image/IndicatorField.h"

#include <vector>

namespace tissue
{
/** \brief Fits the corners of a dual to the image more finely than its voxels.
 *
 * Each corner that the image has goes to where the indicators of its cells are equal. Then corners are moved apart so
 * that every triple line is at least a voxel long and runs from its one corner to the other as it does in the image.
 *
 * `cellOf` has the cell of each vertex of the complex. Returned are the corners of four cells that the image has not,
 * or whose cells' indicators are nowhere equal within three voxels. */
std::vector<std::size_t>
FitCorners(ImageDual & dual, const std::vector<VertexId> & cellOf, const IndicatorField & field);
} // namespace tissue

#endif
