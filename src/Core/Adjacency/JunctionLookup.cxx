/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Adjacency/JunctionLookup.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** In a list that is sorted by `cells`, ascending tuples. */
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
} // namespace tissue
