/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_GeodesicSeeds_h
#define TissueTessellationCore_GeodesicSeeds_h

#include "Nerve/KuhnWall.h"

#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>
#include <unordered_map>

namespace tissue
{
/** \brief Divides a set of voxels among seeds, each voxel to the nearest by steps of the Kuhn subdivision within the
 * set, so that the part of each seed is one piece. Of two seeds as near the one that was there first keeps a voxel. */
class GeodesicSeeds
{
public:
  static constexpr int None = -1;

  /** \param region each voxel once, in an order that is kept; the lengths of steps are those of the volume. */
  GeodesicSeeds(const LabelVolume & volume, std::vector<VoxelIndex> region);

  /** Puts a seed onto a voxel of the region, and gives it what it is nearer to than all seeds before. */
  void
  Add(const VoxelIndex & voxel);

  /** Puts seeds onto voxels of the region, each time the one that is the farthest from all seeds, until none is farther
   * than half the largest distance between two of them: four on a disk, or a ring, and six on a sphere. After the
   * first sixteen, seeds reach but twice that distance at first, and all that is beyond is as far. */
  void
  Cover(const std::vector<VoxelIndex> & voxels);

  /** Lets the seeds reach the rest of the region; to be called after the last. */
  void
  Finish();

  int
  NumberOfSeeds() const
  {
    return m_NumberOfSeeds;
  }
  const std::vector<VoxelIndex> &
  GetRegion() const
  {
    return m_Region;
  }
  /** Of a voxel of the region by its index there; None of one that no seed leads to. */
  int
  SeedOf(std::size_t index) const
  {
    return m_Seeds[index];
  }

private:
  /** The distance of a voxel, its seed and its index: the order is that in which voxels are reached for good. */
  using Entry = std::tuple<double, int, std::size_t>;

  void
  Reach(const Entry & entry);

  /** Reaches all voxels up to a distance from their seeds. */
  void
  Spread(double limit);

  void
  Put(const VoxelIndex & voxel, double limit);

  double
  DistanceTo(const VoxelIndex & voxel) const
  {
    return m_Distances[static_cast<std::size_t>(this->IndexOf(voxel))];
  }

  /** None of a voxel that is not in the region. */
  std::int32_t
  IndexOf(const VoxelIndex & voxel) const;

  const LabelVolume &                            m_Volume;
  std::array<double, 14>                         m_Lengths;
  std::vector<VoxelIndex>                        m_Region;
  std::unordered_map<std::int64_t, std::int32_t> m_IndexOf;
  /** In the region, by index and step. */
  std::vector<std::array<std::int32_t, 14>>                           m_Neighbors;
  std::vector<double>                                                 m_Distances;
  std::vector<int>                                                    m_Seeds;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_Open;
  int                                                                 m_NumberOfSeeds = 0;
};
} // namespace tissue

#endif
