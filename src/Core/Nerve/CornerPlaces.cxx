/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/TissuePlaces.h"
#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <cstdlib>

namespace tissue
{
namespace
{
/** Four of the cells of a block. */
struct Meeting
{
  VertexQuadruple cells;
  VoxelIndex      base;
};

std::vector<Meeting>
FindMeetings(const std::vector<CrowdedBlock> & blocks)
{
  std::vector<Meeting> meetings;
  for (const CrowdedBlock & block : blocks)
  {
    const auto [cells, count] = DifferentCells(block.cells);
    for (int i = 0; i < count; ++i)
    {
      for (int j = i + 1; j < count; ++j)
      {
        for (int k = j + 1; k < count; ++k)
        {
          for (int l = k + 1; l < count; ++l)
          {
            meetings.push_back({ { { cells[i], cells[j], cells[k], cells[l] } }, block.base });
          }
        }
      }
    }
  }
  // The blocks of the same cells keep their raster order.
  std::stable_sort(
    meetings.begin(), meetings.end(), [](const Meeting & a, const Meeting & b) { return a.cells < b.cells; });
  return meetings;
}

bool
Touch(const VoxelIndex & a, const VoxelIndex & b)
{
  return std::abs(a[0] - b[0]) <= 1 && std::abs(a[1] - b[1]) <= 1 && std::abs(a[2] - b[2]) <= 1;
}

/** The places of the blocks [begin, end) of the same four cells. */
void
AppendPlaces(const LabelVolume & volume, const Meeting * begin, const Meeting * end, std::vector<CornerPlace> & places)
{
  const auto   count = static_cast<std::size_t>(end - begin);
  DisjointSets sets(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    // Planes come in order: those that a block may touch follow it.
    for (std::size_t j = i + 1; j < count && begin[j].base[2] <= begin[i].base[2] + 1; ++j)
    {
      if (Touch(begin[i].base, begin[j].base))
      {
        sets.Unite(static_cast<std::int64_t>(i), static_cast<std::int64_t>(j));
      }
    }
  }
  const std::size_t        first = places.size();
  std::vector<std::size_t> placeOf(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto root = static_cast<std::size_t>(sets.Find(static_cast<std::int64_t>(i)));
    if (root == i)
    {
      placeOf[i] = places.size();
      places.push_back({ begin->cells, 0, { { 0.0, 0.0, 0.0 } } });
    }
    CornerPlace & place = places[placeOf[root]];
    ++place.numberOfBlocks;
    for (int axis = 0; axis < 3; ++axis)
    {
      place.position[axis] += begin[i].base[axis] + 0.5;
    }
  }
  for (std::size_t i = first; i < places.size(); ++i)
  {
    places[i].position = volume.ToPhysical((1.0 / static_cast<double>(places[i].numberOfBlocks)) * places[i].position);
  }
}
} // namespace

std::vector<CornerPlace>
FindCornerPlaces(const LabelVolume & volume, const std::vector<CrowdedBlock> & blocks)
{
  const std::vector<Meeting> meetings = FindMeetings(blocks);
  std::vector<CornerPlace>   places;
  std::size_t                begin = 0;
  while (begin < meetings.size())
  {
    std::size_t end = begin;
    while (end < meetings.size() && meetings[end].cells == meetings[begin].cells)
    {
      ++end;
    }
    AppendPlaces(volume, meetings.data() + begin, meetings.data() + end, places);
    begin = end;
  }
  places.shrink_to_fit();
  return places;
}
} // namespace tissue
