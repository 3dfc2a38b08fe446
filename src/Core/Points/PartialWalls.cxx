/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/PartialWalls.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace tissue
{
namespace
{
using LabelPair = std::pair<std::int32_t, std::int32_t>;

/** The offsets of the voxels of the smaller labels at the walls of each two cells, one for each face. */
std::map<LabelPair, std::vector<std::size_t>>
FindWalls(const std::vector<std::int32_t> & labels, const TissueGrid & grid)
{
  std::map<LabelPair, std::vector<std::size_t>> walls;
  const auto                                    add = [&](std::size_t a, std::size_t b) {
    if (labels[a] != labels[b] && labels[a] > 0 && labels[b] > 0)
    {
      walls[std::minmax(labels[a], labels[b])].push_back(labels[a] < labels[b] ? a : b);
    }
  };
  for (std::int32_t z = 0; z < grid.size[2]; ++z)
  {
    for (std::int32_t y = 0; y < grid.size[1]; ++y)
    {
      for (std::int32_t x = 0; x < grid.size[0]; ++x)
      {
        const std::size_t at = grid.Offset(x, y, z);
        if (x > 0)
        {
          add(at, grid.Offset(x - 1, y, z));
        }
        if (y > 0)
        {
          add(at, grid.Offset(x, y - 1, z));
        }
        if (z > 0)
        {
          add(at, grid.Offset(x, y, z - 1));
        }
      }
    }
  }
  return walls;
}

/** The label that is most common around a voxel but for those of a wall and the exterior's, of several the least; 0
 * where there is none. */
std::int32_t
FindThirdCell(const std::vector<std::int32_t> & labels, const TissueGrid & grid, std::size_t at, const LabelPair & wall)
{
  const auto                        sizeX = static_cast<std::size_t>(grid.size[0]);
  const auto                        sizeY = static_cast<std::size_t>(grid.size[1]);
  const std::array<std::int32_t, 3> center{ { static_cast<std::int32_t>(at % sizeX),
                                              static_cast<std::int32_t>(at / sizeX % sizeY),
                                              static_cast<std::int32_t>(at / sizeX / sizeY) } };
  std::map<std::int32_t, int>       counts;
  const auto                        last = [&](int axis) { return std::min(center[axis] + 1, grid.size[axis] - 1); };
  for (std::int32_t z = std::max(center[2] - 1, 0); z <= last(2); ++z)
  {
    for (std::int32_t y = std::max(center[1] - 1, 0); y <= last(1); ++y)
    {
      for (std::int32_t x = std::max(center[0] - 1, 0); x <= last(0); ++x)
      {
        const std::int32_t label = labels[grid.Offset(x, y, z)];
        if (label > 0 && label != wall.first && label != wall.second)
        {
          ++counts[label];
        }
      }
    }
  }
  const auto most =
    std::max_element(counts.begin(), counts.end(), [](const auto & a, const auto & b) { return a.second < b.second; });
  return most == counts.end() ? 0 : most->first;
}
} // namespace

void
RemovePartialWalls(std::vector<std::int32_t> & labels, const TissueGrid & grid, double leastFaces)
{
  // The smallest wall goes first, which makes the one that crosses it larger; the walls of its cells wait for the next
  // pass, when their faces are counted anew.
  constexpr int mostPasses = 10;
  bool          isChanged = true;
  for (int pass = 0; pass < mostPasses && isChanged; ++pass)
  {
    isChanged = false;
    const auto                                     walls = FindWalls(labels, grid);
    std::vector<std::pair<std::size_t, LabelPair>> partial;
    for (const auto & [cells, voxels] : walls)
    {
      if (static_cast<double>(voxels.size()) < leastFaces)
      {
        partial.emplace_back(voxels.size(), cells);
      }
    }
    std::sort(partial.begin(), partial.end());
    std::set<std::int32_t> touched;
    for (const auto & [size, cells] : partial)
    {
      if (touched.count(cells.first) > 0 || touched.count(cells.second) > 0)
      {
        continue;
      }
      for (const std::size_t at : walls.at(cells))
      {
        const std::int32_t third = FindThirdCell(labels, grid, at, cells);
        if (third > 0)
        {
          labels[at] = third;
          touched.insert({ cells.first, cells.second, third });
          isChanged = true;
        }
      }
    }
  }
}
} // namespace tissue
