/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Adjacency/Voids.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** Of several that become one tuple the one with most comes first, and keeps its position. */
std::int64_t
Weight(const Wall & wall)
{
  return wall.numberOfFaces;
}

double
Weight(const JunctionVote & vote)
{
  return vote.share;
}

template <typename TItem>
std::int64_t
Weight(const TItem & item)
{
  return item.numberOfBlocks;
}

void
Join(Wall & wall, const Wall & other)
{
  const double area = wall.area + other.area;
  wall.center = (wall.area / area) * wall.center + (other.area / area) * other.center;
  wall.area = area;
  wall.numberOfFaces += other.numberOfFaces;
}

void
Join(TripleLine & line, const TripleLine & other)
{
  line.numberOfBlocks += other.numberOfBlocks;
}

void
Join(Junction & junction, const Junction & other)
{
  junction.numberOfBlocks += other.numberOfBlocks;
  junction.numberOfExactBlocks += other.numberOfExactBlocks;
  junction.numberOfClusters += other.numberOfClusters;
}

void
Join(JunctionVote &, const JunctionVote &)
{}

/** Replaces the vertices of each item by `rename`, drops those in which two become the same, joins equal ones. */
template <typename TItem, typename TRename>
void
Rename(std::vector<TItem> & items, const TRename & rename)
{
  std::vector<TItem> renamed;
  for (TItem & item : items)
  {
    rename(item.cells);
    std::sort(item.cells.begin(), item.cells.end());
    if (std::adjacent_find(item.cells.begin(), item.cells.end()) == item.cells.end())
    {
      renamed.push_back(item);
    }
  }
  std::stable_sort(renamed.begin(), renamed.end(), [](const TItem & a, const TItem & b) {
    return a.cells != b.cells ? a.cells < b.cells : Weight(a) > Weight(b);
  });
  items.clear();
  for (const TItem & item : renamed)
  {
    if (!items.empty() && items.back().cells == item.cells)
    {
      Join(items.back(), item);
    }
    else
    {
      items.push_back(item);
    }
  }
}

template <typename TRename>
void
RenameAll(JunctionSet & junctions, const TRename & rename)
{
  Rename(junctions.walls, rename);
  Rename(junctions.tripleLines, rename);
  Rename(junctions.junctions, rename);
  Rename(junctions.votes, rename);
}
} // namespace

JunctionSet
MergeVoids(const JunctionSet & junctions)
{
  JunctionSet merged = junctions;
  RenameAll(merged, [&junctions](auto & cells) {
    std::replace_if(
      cells.begin(), cells.end(), [&junctions](VertexId v) { return junctions.IsVoid(v); }, ExteriorVertex);
  });
  Cell & exterior = merged.cells[ExteriorVertex];
  for (const Cell & enclosed : merged.voids)
  {
    exterior.numberOfVoxels += enclosed.numberOfVoxels;
    exterior.numberOfStrayVoxels += enclosed.numberOfVoxels;
    exterior.volume += enclosed.volume;
    ++exterior.numberOfPieces;
  }
  merged.voids.clear();
  return merged;
}

JunctionSet
MergeVoidsOfOtherParts(const JunctionSet & junctions, const std::vector<int> & partOfVertex)
{
  JunctionSet merged = junctions;
  RenameAll(merged, [&](auto & cells) {
    const auto isCell = [&](VertexId v) { return v != ExteriorVertex && !junctions.IsVoid(v); };
    const auto cell = std::find_if(cells.begin(), cells.end(), isCell);
    const int  part = cell != cells.end() ? partOfVertex[*cell] : -1;
    std::replace_if(
      cells.begin(),
      cells.end(),
      [&](VertexId v) { return junctions.IsVoid(v) && partOfVertex[v] != part; },
      ExteriorVertex);
  });
  return merged;
}

} // namespace tissue
