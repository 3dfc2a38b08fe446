/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/GeodesicSeeds.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
GeodesicSeeds::Reach(const Entry & entry)
{
  const auto [distance, seed, i] = entry;
  if (distance < m_Distances[i] || (distance == m_Distances[i] && seed < m_Seeds[i]))
  {
    m_Distances[i] = distance;
    m_Seeds[i] = seed;
    m_Open.push(entry);
  }
}

void
GeodesicSeeds::Spread(double limit)
{
  while (!m_Open.empty() && std::get<0>(m_Open.top()) <= limit)
  {
    const auto [distance, seed, i] = m_Open.top();
    m_Open.pop();
    for (std::size_t s = 0; distance == m_Distances[i] && seed == m_Seeds[i] && s < m_Lengths.size(); ++s)
    {
      if (m_Neighbors[i][s] != None)
      {
        this->Reach({ distance + m_Lengths[s], seed, static_cast<std::size_t>(m_Neighbors[i][s]) });
      }
    }
  }
}

void
GeodesicSeeds::Put(const VoxelIndex & voxel, double limit)
{
  this->Reach({ 0.0, m_NumberOfSeeds, static_cast<std::size_t>(this->IndexOf(voxel)) });
  ++m_NumberOfSeeds;
  this->Spread(limit);
}

void
GeodesicSeeds::Add(const VoxelIndex & voxel)
{
  this->Put(voxel, std::numeric_limits<double>::max());
}

void
GeodesicSeeds::Cover(const std::vector<VoxelIndex> & voxels)
{
  const VoxelIndex & first = FarthestFrom(m_Volume, voxels.front(), voxels);
  const VoxelIndex & last = FarthestFrom(m_Volume, first, voxels);
  const double       extent = Distance(PlaceOf(m_Volume, first), PlaceOf(m_Volume, last));
  // Seeds that come one beside the other, as those of a row of rings do, would each take half of all that is left from
  // those before, in a time that grows with the square of their number.
  constexpr int    seedsThatSpreadAll = 16;
  constexpr double extentsToSpread = 2.0;
  const auto       limit = [&] {
    return m_NumberOfSeeds < seedsThatSpreadAll ? std::numeric_limits<double>::max() : extentsToSpread * extent;
  };
  if (m_NumberOfSeeds == 0)
  {
    this->Put(first, limit());
  }
  this->Spread(limit());
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
    this->Put(*farthest, limit());
  }
}

void
GeodesicSeeds::Finish()
{
  this->Spread(std::numeric_limits<double>::max());
}
} // namespace tissue
