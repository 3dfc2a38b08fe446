/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Adjacency/SeparatedCells.h"

#include <cmath>

namespace tissue
{
namespace
{
/** Whether the centres of two cells are at most `reach` times the sum of the radii of their balls apart. */
bool
AreNear(const Cell & a, const Cell & b, double reach)
{
  // The volume of a ball of radius 1, 4 pi / 3.
  constexpr double ballOfUnitRadius = 4.1887902047863905;
  const double     radii = std::cbrt(a.volume / ballOfUnitRadius) + std::cbrt(b.volume / ballOfUnitRadius);
  const double distance = std::hypot(a.center[0] - b.center[0], a.center[1] - b.center[1], a.center[2] - b.center[2]);
  return distance <= reach * radii;
}
} // namespace

std::vector<VertexId>
FindSeparatedCells(const JunctionSet & junctions, double reach)
{
  const std::vector<Cell> & cells = junctions.cells;
  std::vector<bool>         touchesCell(cells.size(), false);
  for (const Wall & wall : junctions.walls)
  {
    if (wall.cells[0] != ExteriorVertex)
    {
      touchesCell[wall.cells[0]] = true;
      touchesCell[wall.cells[1]] = true;
    }
  }
  std::vector<VertexId> separated;
  const auto            count = static_cast<VertexId>(cells.size());
  for (VertexId cell = 1; cell < count; ++cell)
  {
    bool isNear = false;
    for (VertexId other = 1; other < count && !touchesCell[cell] && !isNear; ++other)
    {
      isNear = other != cell && AreNear(cells[cell], cells[other], reach);
    }
    if (isNear)
    {
      separated.push_back(cell);
    }
  }
  return separated;
}
} // namespace tissue
