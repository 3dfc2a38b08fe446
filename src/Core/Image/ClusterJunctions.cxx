/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Image/ClusterJunctions.h"

#include <algorithm>

namespace tissue
{
namespace
{
using Quadruple = BlockScan::Quadruple;
using QuadrupleIterator = std::vector<Quadruple>::const_iterator;

/** Blocks of one cluster are chained by steps of at most this many voxels along each axis. With 2 one block between may
 * lack a cell, as ragged boundaries have it, and the junction still is at one place. */
constexpr std::int32_t Reach = 2;

bool
IsBefore(const BlockScan::Index & a, const BlockScan::Index & b)
{
  return std::lexicographical_compare(a.crbegin(), a.crend(), b.crbegin(), b.crend());
}

/** Puts the blocks [begin, end), which must be in raster order, into clusters. */
DisjointSets
FindClusters(QuadrupleIterator begin, QuadrupleIterator end)
{
  DisjointSets clusters(end - begin);
  for (auto block = begin; block != end; ++block)
  {
    // The neighbours that come before the block are in a few rows, in each of which they are consecutive.
    for (std::int32_t z = block->corner[2] - Reach; z <= block->corner[2]; ++z)
    {
      const std::int32_t lastY = block->corner[1] + (z < block->corner[2] ? Reach : 0);
      for (std::int32_t y = block->corner[1] - Reach; y <= lastY; ++y)
      {
        const BlockScan::Index first = { { block->corner[0] - Reach, y, z } };
        auto                   other = std::lower_bound(
          begin, block, first, [](const Quadruple & q, const BlockScan::Index & i) { return IsBefore(q.corner, i); });
        for (; other != block && other->corner[1] == y && other->corner[2] == z &&
               other->corner[0] <= block->corner[0] + Reach;
             ++other)
        {
          clusters.Unite(other - begin, block - begin);
        }
      }
    }
  }
  return clusters;
}

/** Makes the junction of the blocks [begin, end), which must be all blocks of one quadruple, in raster order.
 *
 * The blocks are clustered, as the same four cells may meet at several places; the junction is at the mean of the
 * corners of its largest cluster. */
Junction
MakeJunction(QuadrupleIterator begin, QuadrupleIterator end)
{
  struct Cluster
  {
    std::int64_t                numberOfBlocks = 0;
    std::array<std::int64_t, 3> sum = { { 0, 0, 0 } };
  };
  DisjointSets         sets = FindClusters(begin, end);
  std::vector<Cluster> clusters(sets.GetSize());
  for (auto block = begin; block != end; ++block)
  {
    Cluster & cluster = clusters[sets.Find(block - begin)];
    ++cluster.numberOfBlocks;
    for (int axis = 0; axis < 3; ++axis)
    {
      cluster.sum[axis] += block->corner[axis];
    }
  }
  const auto isSmaller = [](const Cluster & a, const Cluster & b) { return a.numberOfBlocks < b.numberOfBlocks; };
  const auto largest = std::max_element(clusters.cbegin(), clusters.cend(), isSmaller);

  Junction junction;
  junction.cells = begin->cells;
  junction.numberOfBlocks = end - begin;
  junction.numberOfExactBlocks = std::count_if(begin, end, [](const Quadruple & q) { return q.exact; });
  junction.numberOfClusters = static_cast<std::int32_t>(
    std::count_if(clusters.cbegin(), clusters.cend(), [](const Cluster & c) { return c.numberOfBlocks > 0; }));
  for (int axis = 0; axis < 3; ++axis)
  {
    // The padded corner c lies between the image's voxels c - 2 and c - 1.
    junction.position[axis] =
      static_cast<double>(largest->sum[axis]) / static_cast<double>(largest->numberOfBlocks) - 1.5;
  }
  return junction;
}
} // namespace

std::vector<Junction>
ClusterJunctions(std::vector<Quadruple> quadruples)
{
  std::sort(quadruples.begin(), quadruples.end(), [](const Quadruple & a, const Quadruple & b) {
    return a.cells != b.cells ? a.cells < b.cells : IsBefore(a.corner, b.corner);
  });
  std::vector<Junction> junctions;
  for (auto begin = quadruples.cbegin(); begin != quadruples.cend();)
  {
    const auto end =
      std::find_if(begin, quadruples.cend(), [&](const Quadruple & q) { return q.cells != begin->cells; });
    junctions.push_back(MakeJunction(begin, end));
    begin = end;
  }
  return junctions;
}
} // namespace tissue
