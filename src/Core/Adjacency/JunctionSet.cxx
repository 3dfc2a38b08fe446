/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include "Common/Algorithms.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <utility>

namespace tissue
{
namespace
{
/** Finds the entry of some cells, given in any order, in a list that is sorted by `cells`, whose tuples ascend. */
template <typename TEntry, typename TTuple>
const TEntry *
Find(const std::vector<TEntry> & entries, TTuple cells)
{
  std::sort(cells.begin(), cells.end());
  const auto at = std::lower_bound(
    entries.begin(), entries.end(), cells, [](const TEntry & entry, const TTuple & c) { return entry.cells < c; });
  return at != entries.end() && at->cells == cells ? &*at : nullptr;
}
} // namespace

const Wall *
FindWall(const JunctionSet & junctions, VertexPair cells)
{
  return Find(junctions.walls, cells);
}

const Junction *
FindJunction(const JunctionSet & junctions, VertexQuadruple cells)
{
  return Find(junctions.junctions, cells);
}

double
MedianNeighborDistance(const JunctionSet & junctions)
{
  std::vector<double> distances;
  for (const Wall & wall : junctions.walls)
  {
    if (wall.cells[0] != ExteriorVertex)
    {
      distances.push_back(Distance(junctions.cells[wall.cells[0]].center, junctions.cells[wall.cells[1]].center));
    }
  }
  if (distances.empty())
  {
    return 0.0;
  }
  return Median(std::move(distances));
}
} // namespace tissue
