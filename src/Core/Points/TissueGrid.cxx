/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Points/TissueGrid.h"

#include <algorithm>
#include <cmath>

namespace tissue
{
std::size_t
TissueGrid::OffsetAt(const Point & position) const
{
  std::array<std::int32_t, 3> index;
  for (int i = 0; i < 3; ++i)
  {
    index[i] = static_cast<std::int32_t>(std::clamp((position[i] - lower[i]) / steps[i], 0.0, size[i] - 1.0));
  }
  return Offset(index[0], index[1], index[2]);
}

TissueGrid
MakeTissueGrid(const Box & box, double step)
{
  TissueGrid grid;
  grid.lower = box.lower;
  for (int i = 0; i < 3; ++i)
  {
    const double extent = box.upper[i] - box.lower[i];
    grid.size[i] = static_cast<std::int32_t>(std::max(1L, std::lround(extent / step)));
    grid.steps[i] = extent / grid.size[i];
  }
  return grid;
}
} // namespace tissue
