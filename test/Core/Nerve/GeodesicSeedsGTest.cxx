/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/GeodesicSeeds.h"
#include "Nerve/KuhnFragments.h"

#include "Nerve/TestImages.h"

#include <gtest/gtest.h>

using namespace testing_nerve;

namespace
{
std::vector<VoxelIndex>
VoxelsOf(const LabelVolume & volume, VertexId vertex)
{
  std::vector<VoxelIndex> voxels;
  for (std::int32_t z = 0; z < volume.size[2]; ++z)
  {
    for (std::int32_t y = 0; y < volume.size[1]; ++y)
    {
      for (std::int32_t x = 0; x < volume.size[0]; ++x)
      {
        if (volume.At(x, y, z) == vertex)
        {
          voxels.push_back({ { x, y, z } });
        }
      }
    }
  }
  return voxels;
}
} // namespace

TEST(GeodesicSeeds, GoRoundWhatIsNotInTheRegion)
{
  // Two corridors that are joined at x = 0.
  const LabelVolume volume = MakeImage(
    { { 9, 3, 1 } }, [](std::int32_t x, std::int32_t y, std::int32_t) { return VertexId{ y != 1 || x == 0 ? 1 : 2 }; });
  const auto    voxels = VoxelsOf(volume, 1);
  GeodesicSeeds seeds(volume, voxels);
  EXPECT_EQ(seeds.SeedOf(0), GeodesicSeeds::None);
  seeds.Add({ { 8, 0, 0 } });
  seeds.Add({ { 1, 2, 0 } });
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    const int way = voxels[i][1] == 0 ? 8 - voxels[i][0] : 8 + voxels[i][1] + voxels[i][0];
    EXPECT_EQ(seeds.SeedOf(i) == 0, way <= 5) << voxels[i][0] << ' ' << voxels[i][1];
  }
}

TEST(GeodesicSeeds, CoverASurface)
{
  const LabelVolume volume = MakeImage({ { 30, 30, 30 } }, [](std::int32_t x, std::int32_t y, std::int32_t z) {
    const double r = Norm({ { x - 14.5, y - 14.5, z - 14.5 } });
    return VertexId{ r > 11.0 && r < 13.0 ? 1 : 0 };
  });
  const auto        voxels = VoxelsOf(volume, 1);
  GeodesicSeeds     seeds(volume, voxels);
  seeds.Cover(voxels);
  EXPECT_GE(seeds.NumberOfSeeds(), 4);
  EXPECT_LE(seeds.NumberOfSeeds(), 14);
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    EXPECT_NE(seeds.SeedOf(i), GeodesicSeeds::None);
  }
  const int before = seeds.NumberOfSeeds();
  seeds.Cover(voxels);
  EXPECT_EQ(seeds.NumberOfSeeds(), before);
}

TEST(GeodesicSeeds, HaveConnectedParts)
{
  for (std::uint64_t seed = 280; seed <= 300; ++seed)
  {
    const LabelVolume volume = Noise({ { 9, 9, 9 } }, 2, seed);
    const auto        voxels = VoxelsOf(volume, 1);
    GeodesicSeeds     seeds(volume, voxels);
    Random            random(seed);
    for (int i = 0; i < 12; ++i)
    {
      seeds.Add(voxels[random.Index(voxels.size())]);
    }
    LabelVolume parts = volume;
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      const VoxelIndex & p = voxels[i];
      parts.vertices.Put(static_cast<std::size_t>((p[2] * 9 + p[1]) * 9 + p[0]), 1 + seeds.SeedOf(i));
    }
    EXPECT_TRUE(FindFragments(parts, 1 + seeds.NumberOfSeeds()).fragments.empty()) << seed;
  }
}

TEST(GeodesicSeeds, CoverARowOfSurfacesWithAsManyEach)
{
  // Those past the sixteenth seed do not spread over all of the bar at once.
  constexpr std::int32_t length = 400;
  const LabelVolume      volume =
    MakeImage({ { length, 6, 6 } }, [](std::int32_t, std::int32_t, std::int32_t) { return VertexId{ 1 }; });
  const auto    voxels = VoxelsOf(volume, 1);
  GeodesicSeeds seeds(volume, voxels);
  for (std::int32_t x = 0; x < length; x += 20)
  {
    const int               before = seeds.NumberOfSeeds();
    std::vector<VoxelIndex> surface;
    for (const VoxelIndex & p : voxels)
    {
      if (p[0] >= x && p[0] < x + 10 && p[2] == 0)
      {
        surface.push_back(p);
      }
    }
    seeds.Cover(surface);
    EXPECT_GE(seeds.NumberOfSeeds() - before, 1) << x;
    EXPECT_LE(seeds.NumberOfSeeds() - before, 4) << x;
  }
  seeds.Finish();
  LabelVolume parts = volume;
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    const VoxelIndex & p = voxels[i];
    ASSERT_NE(seeds.SeedOf(i), GeodesicSeeds::None);
    parts.vertices.Put(static_cast<std::size_t>((p[2] * 6 + p[1]) * length + p[0]), 1 + seeds.SeedOf(i));
  }
  EXPECT_TRUE(FindFragments(parts, 1 + seeds.NumberOfSeeds()).fragments.empty());
}
