/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PartialWalls_h
#define TissueTessellationCore_PartialWalls_h

#include "TissueTessellationCore/Points/TissueGrid.h"

#include <cstdint>
#include <vector>

namespace tissue
{
/** \brief Takes walls out of the label image of a layer that do not go across it.
 *
 * Where four cells nearly meet along a line across the layer, the voxels show now two of them touching and now the
 * other two, from one depth to the next. Only one of these walls can go across. A wall of fewer faces than asked for
 * goes: the voxels of the cell of the smaller label there become the third cell's that is most common around each. A
 * wall without a third cell near by, at a rim, stays.
 *
 * \param labels of the cells, in the order of the grid's points; 0 for the exterior.
 * \param leastFaces the faces of a wall that stays. */
void
RemovePartialWalls(std::vector<std::int32_t> & labels, const TissueGrid & grid, double leastFaces);
} // namespace tissue

#endif
