/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/PlaneScan.h"
#include "Nerve/TestImages.h"

#include <gtest/gtest.h>

#include <set>

using namespace testing_nerve;

namespace
{
struct Found
{
  std::set<VoxelIndex> withFaces;
  std::set<VoxelIndex> blocks;
};

/** What a scan of all planes finds; expects it in raster order, with the voxels of the image. */
Found
Scan(const LabelVolume & volume)
{
  Found      found;
  PlaneScan  scan(volume, -1);
  const auto rank = [](const VoxelIndex & p) { return std::array<std::int32_t, 3>{ { p[2], p[1], p[0] } }; };
  VoxelIndex last{ { -2, -2, -2 } };
  for (std::int32_t z = -1; z < volume.size[2]; ++z)
  {
    scan.Visit(
      [&](std::size_t p, const VoxelIndex & voxel) {
        EXPECT_LT(rank(last), rank(voxel));
        last = voxel;
        EXPECT_EQ(scan.CellsAt(p)[0], volume.At(voxel[0], voxel[1], voxel[2]));
        EXPECT_EQ(scan.CellsAt(p)[2], volume.At(voxel[0], voxel[1] + 1, voxel[2]));
        found.withFaces.insert(voxel);
      },
      [&](const CrowdedBlock & block) {
        EXPECT_EQ(block.cells[6], volume.At(block.base[0], block.base[1] + 1, block.base[2] + 1));
        found.blocks.insert(block.base);
      });
    scan.Advance();
  }
  return found;
}

template <typename TVisitor>
void
ForEachVoxelAndBorder(const LabelVolume & volume, const TVisitor & visit)
{
  for (std::int32_t z = -1; z < volume.size[2]; ++z)
  {
    for (std::int32_t y = -1; y < volume.size[1]; ++y)
    {
      for (std::int32_t x = -1; x < volume.size[0]; ++x)
      {
        visit(VoxelIndex{ { x, y, z } });
      }
    }
  }
}

bool
HasFaces(const LabelVolume & volume, const VoxelIndex & p)
{
  const VertexId v = volume.At(p[0], p[1], p[2]);
  return v != volume.At(p[0] + 1, p[1], p[2]) || v != volume.At(p[0], p[1] + 1, p[2]) ||
         v != volume.At(p[0], p[1], p[2] + 1);
}

bool
IsCrowdedAt(const LabelVolume & volume, const VoxelIndex & p)
{
  BlockVoxels voxels;
  for (int set = 0; set < 8; ++set)
  {
    voxels[set] = volume.At(p[0] + (set & 1), p[1] + (set >> 1 & 1), p[2] + (set >> 2));
  }
  return IsCrowded(voxels);
}
} // namespace

TEST(PlaneScan, FindsAllFacesAndAllCrowdedBlocks)
{
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
  {
    const LabelVolume volume =
      seed % 2 == 0
        ? Noise({ { static_cast<std::int32_t>(1 + seed), 4, 5 } }, static_cast<VertexId>(2 + seed % 7), seed)
        : Bricks({ { 3, 2, 2 } }, static_cast<std::int32_t>(2 + seed % 5));
    const Found found = Scan(volume);
    ForEachVoxelAndBorder(volume, [&](const VoxelIndex & p) {
      EXPECT_EQ(found.withFaces.count(p) != 0, HasFaces(volume, p)) << seed;
      EXPECT_TRUE(found.blocks.count(p) != 0 || !IsCrowdedAt(volume, p)) << seed;
    });
  }
}

TEST(PlaneScan, PassesOverStraightWallsAndLines)
{
  // Two layers, one of them of two cells: walls along the axes, and a line where three cells meet.
  const LabelVolume volume =
    MakeImage({ { 20, 20, 20 } }, [](std::int32_t, std::int32_t y, std::int32_t z) -> VertexId {
      return z < 9 ? 1 : y < 7 ? 2 : 3;
    });
  for (const VoxelIndex & base : Scan(volume).blocks)
  {
    EXPECT_TRUE(base[0] < 0 || base[0] == 19);
  }
}

TEST(PlaneScan, TakesEachPlaneOnceInSlabs)
{
  for (const std::int32_t planes : { 1, 31, 32, 63, 64, 200 })
  {
    LabelVolume volume;
    volume.size = { { 1, 1, planes } };
    std::int32_t next = -1;
    for (const Slab & slab : SlabsOf(volume))
    {
      EXPECT_EQ(slab.begin, next);
      EXPECT_LT(slab.begin, slab.end);
      next = slab.end;
    }
    EXPECT_EQ(next, planes);
  }
}
