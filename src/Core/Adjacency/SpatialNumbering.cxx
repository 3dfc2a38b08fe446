/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/SpatialNumbering.h"

#include "Geometry/SpatialOrder.h"

#include <algorithm>

namespace tissue
{
namespace
{
template <typename TItem>
void
RenumberItems(std::vector<TItem> & items, const std::vector<VertexId> & ranks)
{
  for (TItem & item : items)
  {
    for (VertexId & v : item.cells)
    {
      v = ranks[v];
    }
    std::sort(item.cells.begin(), item.cells.end());
  }
  std::sort(items.begin(), items.end(), [](const TItem & a, const TItem & b) { return a.cells < b.cells; });
}
} // namespace

SpatialNumbering
NumberSpatially(const JunctionSet & junctions, const std::vector<Point> & centers)
{
  SpatialNumbering numbering;
  numbering.order = SpatialOrder(centers);
  std::stable_partition(
    numbering.order.begin(), numbering.order.end(), [&junctions](VertexId v) { return !junctions.IsVoid(v); });
  numbering.ranks = RanksInOrder(numbering.order);
  return numbering;
}

JunctionSet
Renumbered(const JunctionSet & junctions, const SpatialNumbering & numbering)
{
  JunctionSet renumbered = junctions;
  for (std::size_t i = 0; i < numbering.order.size(); ++i)
  {
    const bool isCell = i < junctions.cells.size();
    Cell &     cell = isCell ? renumbered.cells[i] : renumbered.voids[i - junctions.cells.size()];
    cell = junctions.CellOfVertex(numbering.order[i]);
  }
  RenumberItems(renumbered.walls, numbering.ranks);
  RenumberItems(renumbered.tripleLines, numbering.ranks);
  RenumberItems(renumbered.junctions, numbering.ranks);
  RenumberItems(renumbered.votes, numbering.ranks);
  return renumbered;
}
} // namespace tissue
