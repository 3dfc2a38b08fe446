/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/TestImages.h"
#include "Nerve/TissuePlaces.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace testing_nerve;

namespace
{
/** The sizes of the walls of each two cells, ascending, by the definition: faces flood over the voxel edges. */
std::map<VertexPair, std::vector<std::int64_t>>
WallSizes(const LabelVolume & volume)
{
  struct Face
  {
    VoxelIndex voxel;
    int        axis;
    bool
    operator<(const Face & other) const
    {
      return voxel != other.voxel ? voxel < other.voxel : axis < other.axis;
    }
  };
  const auto cellsOf = [&](const Face & f) {
    VoxelIndex behind = f.voxel;
    ++behind[f.axis];
    const VertexId a = volume.At(f.voxel[0], f.voxel[1], f.voxel[2]);
    const VertexId b = volume.At(behind[0], behind[1], behind[2]);
    return VertexPair{ { std::min(a, b), std::max(a, b) } };
  };
  std::set<Face> open;
  for (std::int32_t z = -1; z < volume.size[2]; ++z)
  {
    for (std::int32_t y = -1; y < volume.size[1]; ++y)
    {
      for (std::int32_t x = -1; x < volume.size[0]; ++x)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          const Face face{ { { x, y, z } }, axis };
          if (cellsOf(face)[0] != cellsOf(face)[1])
          {
            open.insert(face);
          }
        }
      }
    }
  }
  std::map<VertexPair, std::vector<std::int64_t>> sizes;
  while (!open.empty())
  {
    std::vector<Face> stack{ *open.begin() };
    open.erase(open.begin());
    const VertexPair cells = cellsOf(stack[0]);
    std::int64_t     size = 0;
    while (!stack.empty())
    {
      const Face f = stack.back();
      stack.pop_back();
      ++size;
      for (auto it = open.begin(); it != open.end();)
      {
        // Two faces share an edge where their centres are close; coordinates are doubled.
        std::array<int, 3> d{ { 0, 0, 0 } };
        for (int i = 0; i < 3; ++i)
        {
          d[i] = std::abs(2 * (it->voxel[i] - f.voxel[i]) + (it->axis == i ? 1 : 0) - (f.axis == i ? 1 : 0));
        }
        const bool isFlat = it->axis == f.axis && d[f.axis] == 0 && d[0] + d[1] + d[2] == 2;
        const bool isBent = it->axis != f.axis && d[f.axis] == 1 && d[it->axis] == 1 && d[0] + d[1] + d[2] == 2;
        if ((isFlat || isBent) && cellsOf(*it) == cells)
        {
          stack.push_back(*it);
          it = open.erase(it);
        }
        else
        {
          ++it;
        }
      }
    }
    sizes[cells].push_back(size);
  }
  for (auto & ofCells : sizes)
  {
    std::sort(ofCells.second.begin(), ofCells.second.end(), std::greater<>());
  }
  return sizes;
}

std::map<VertexPair, std::vector<std::int64_t>>
SizesOf(const std::vector<ImageWall> & walls)
{
  std::map<VertexPair, std::vector<std::int64_t>> sizes;
  for (const ImageWall & wall : walls)
  {
    sizes[wall.cells].push_back(wall.numberOfFaces);
  }
  return sizes;
}
} // namespace

TEST(ImageWalls, AreThePiecesOfInterfacesOfNoise)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const LabelVolume volume = Noise({ { 5, 4, 6 } }, static_cast<VertexId>(2 + seed % 5), seed);
    EXPECT_EQ(SizesOf(FindImageWalls(volume)), WallSizes(volume)) << seed;
  }
}

TEST(ImageWalls, GoOnFromSlabToSlab)
{
  // Taller than two slabs, with walls along the height, and one to the exterior all around.
  const LabelVolume volume =
    MakeImage({ { 3, 2, 75 } }, [](std::int32_t x, std::int32_t, std::int32_t) { return VertexId{ 1 + (x > 0) }; });
  const std::map<VertexPair, std::vector<std::int64_t>> expected{ { { { 0, 1 } }, { 4 * 75 + 4 } },
                                                                  { { { 0, 2 } }, { 6 * 75 + 8 } },
                                                                  { { { 1, 2 } }, { 2 * 75 } } };
  const auto                                            walls = FindImageWalls(volume);
  EXPECT_EQ(SizesOf(walls), expected);
  EXPECT_EQ(walls.back().center, (Point{ { 0.5, 0.5, 37.0 } }));
}

TEST(CornerPlaces, AreTheClustersOfBlocksWithFourCells)
{
  // Three bubbles around an axis from end to end of their ball: two places.
  const LabelVolume volume = MakeImage({ { 8, 8, 8 } }, [](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
    return z < 2 || z > 5 ? 0 : x < 4 ? 1 : y < 4 ? 2 : 3;
  });
  const auto        places = FindCornerPlaces(volume, FindCrowdedBlocks(volume));
  ASSERT_EQ(places.size(), 2u);
  for (const CornerPlace & place : places)
  {
    EXPECT_EQ(place.cells, (VertexQuadruple{ { 0, 1, 2, 3 } }));
    EXPECT_EQ(place.numberOfBlocks, 1);
  }
  EXPECT_EQ(places[0].position, (Point{ { 3.5, 3.5, 1.5 } }));
  EXPECT_EQ(places[1].position, (Point{ { 3.5, 3.5, 5.5 } }));
}

TEST(CornerPlaces, CountEachFourCellsOfACrowdedBlock)
{
  const LabelVolume volume =
    MakeImage({ { 2, 2, 1 } }, [](std::int32_t x, std::int32_t y, std::int32_t) -> VertexId { return 1 + x + 2 * y; });
  // In front of the four voxels and behind them lies the exterior: five cells, so five times four, and each at both.
  const auto places = FindCornerPlaces(volume, FindCrowdedBlocks(volume));
  EXPECT_EQ(places.size(), 5u) << "the two blocks touch";
  EXPECT_EQ(places[0].numberOfBlocks, 2);
}
