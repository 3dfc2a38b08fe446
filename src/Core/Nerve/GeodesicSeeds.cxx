/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/GeodesicSeeds.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

namespace tissue
{
namespace
{
Point
PlaceOf(const LabelVolume & volume, const VoxelIndex & p)
{
  return volume.ToPhysical({ { static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]) } });
}

/** The first of the voxels that are the farthest from a place. */
const VoxelIndex &
FarthestFrom(const LabelVolume & volume, const VoxelIndex & from, const std::vector<VoxelIndex> & voxels)
{
  const Point place = PlaceOf(volume, from);
  return *std::max_element(voxels.begin(), voxels.end(), [&](const VoxelIndex & a, const VoxelIndex & b) {
    return Distance(place, PlaceOf(volume, a)) < Distance(place, PlaceOf(volume, b));
  });
}

} // namespace

GeodesicSeeds::GeodesicSeeds(const LabelVolume & volume, std::vector<VoxelIndex> region)
  : m_Volume(volume)
  , m_Region(std::move(region))
  , m_Distances(m_Region.size(), std::numeric_limits<double>::max())
  , m_Seeds(m_Region.size(), None)
{
  for (std::size_t s = 0; s < m_Lengths.size(); ++s)
  {
    m_Lengths[s] = Distance(PlaceOf(volume, { { 0, 0, 0 } }), PlaceOf(volume, KuhnSteps()[s]));
  }
  // Lengths in whole numbers of a power of two add up without rounding. With it a voxel might go to a later seed while
  // one behind it stays, so that the part of a seed would be several pieces.
  const double unit = std::ldexp(1.0, std::ilogb(*std::max_element(m_Lengths.begin(), m_Lengths.end())) - 20);
  for (double & length : m_Lengths)
  {
    length = unit * std::round(length / unit);
  }
  m_IndexOf.reserve(m_Region.size());
  for (std::size_t i = 0; i < m_Region.size(); ++i)
  {
    m_IndexOf.emplace(KeyOfVoxel(volume, m_Region[i]), static_cast<std::int32_t>(i));
  }
  m_Neighbors.resize(m_Region.size());
  for (std::size_t i = 0; i < m_Region.size(); ++i)
  {
    for (std::size_t s = 0; s < m_Lengths.size(); ++s)
    {
      m_Neighbors[i][s] = this->IndexOf(m_Region[i] + KuhnSteps()[s]);
    }
  }
}

std::int32_t
GeodesicSeeds::IndexOf(const VoxelIndex & voxel) const
{
  const auto at = m_IndexOf.find(KeyOfVoxel(m_Volume, voxel));
  return at == m_IndexOf.end() ? None : at->second;
}

void
GeodesicSeeds::Add(const VoxelIndex & voxel)
{
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  const auto                                                          reach = [&](std::size_t i, double distance) {
    if (distance < m_Distances[i])
    {
      m_Distances[i] = distance;
      m_Seeds[i] = m_NumberOfSeeds;
      open.emplace(distance, i);
    }
  };
  reach(static_cast<std::size_t>(this->IndexOf(voxel)), 0.0);
  while (!open.empty())
  {
    const auto [distance, i] = open.top();
    open.pop();
    for (std::size_t s = 0; distance == m_Distances[i] && s < m_Lengths.size(); ++s)
    {
      if (m_Neighbors[i][s] != None)
      {
        reach(static_cast<std::size_t>(m_Neighbors[i][s]), distance + m_Lengths[s]);
      }
    }
  }
  ++m_NumberOfSeeds;
}

void
GeodesicSeeds::Cover(const std::vector<VoxelIndex> & voxels)
{
  const VoxelIndex & first = FarthestFrom(m_Volume, voxels.front(), voxels);
  const VoxelIndex & last = FarthestFrom(m_Volume, first, voxels);
  const double       extent = Distance(PlaceOf(m_Volume, first), PlaceOf(m_Volume, last));
  if (m_NumberOfSeeds == 0)
  {
    this->Add(first);
  }
  while (true)
  {
    const auto farthest =
      std::max_element(voxels.begin(), voxels.end(), [this](const VoxelIndex & a, const VoxelIndex & b) {
        return this->DistanceTo(a) < this->DistanceTo(b);
      });
    if (this->DistanceTo(*farthest) <= 0.5 * extent)
    {
      return;
    }
    this->Add(*farthest);
  }
}
} // namespace tissue
