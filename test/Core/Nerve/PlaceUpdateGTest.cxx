/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/PlaceUpdate.h"
#include "Nerve/TestImages.h"

#include <gtest/gtest.h>

using namespace testing_nerve;

namespace
{
/** Gives random voxels of a box other vertices. */
std::vector<VoxelChange>
Change(LabelVolume & volume, const VoxelIndex & least, const VoxelIndex & most, VertexId numberOfVertices,
       Random & random)
{
  std::vector<VoxelChange> changes;
  for (std::int32_t z = least[2]; z <= most[2]; ++z)
  {
    for (std::int32_t y = least[1]; y <= most[1]; ++y)
    {
      for (std::int32_t x = least[0]; x <= most[0]; ++x)
      {
        const auto i = static_cast<std::size_t>((z * volume.size[1] + y) * volume.size[0] + x);
        if (random.Index(2) == 0)
        {
          changes.push_back({ { { x, y, z } }, volume.vertices[i] });
          volume.vertices.Put(i, static_cast<VertexId>(random.Index(static_cast<std::size_t>(numberOfVertices))));
        }
      }
    }
  }
  return changes;
}

void
ExpectSameBlocks(const std::vector<CrowdedBlock> & updated, const std::vector<CrowdedBlock> & found)
{
  ASSERT_EQ(updated.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(updated[i].base, found[i].base);
    EXPECT_EQ(updated[i].cells, found[i].cells);
  }
}

void
ExpectSameWalls(const std::vector<ImageWall> & updated, const std::vector<ImageWall> & found)
{
  ASSERT_EQ(updated.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(updated[i].cells, found[i].cells);
    EXPECT_EQ(updated[i].numberOfFaces, found[i].numberOfFaces);
    EXPECT_EQ(updated[i].center, found[i].center);
    EXPECT_EQ(updated[i].face, found[i].face);
  }
}

/** Changes a box of the image again and again, of which each time all is to be as if it were found anew. */
void
ExpectUpdatesOf(LabelVolume volume, const VoxelIndex & least, const VoxelIndex & most, std::uint64_t seed)
{
  SCOPED_TRACE(seed);
  Random         random(seed);
  const VertexId vertices = NumberOfVertices(volume) + 1;
  auto           blocks = FindCrowdedBlocks(volume);
  auto           walls = FindImageWalls(volume);
  for (int step = 0; step < 5; ++step)
  {
    const auto changes = Change(volume, least, most, vertices, random);
    UpdateCrowdedBlocks(volume, changes, blocks);
    UpdateImageWalls(volume, changes, walls);
    ExpectSameBlocks(blocks, FindCrowdedBlocks(volume));
    ExpectSameWalls(walls, FindImageWalls(volume));
  }
}
} // namespace

TEST(PlaceUpdate, IsAsFoundAnew)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    ExpectUpdatesOf(
      Noise({ { 20, 21, 22 } }, static_cast<VertexId>(2 + seed % 5), seed), { { 9, 3, 11 } }, { { 12, 5, 14 } }, seed);
    ExpectUpdatesOf(Bricks({ { 3, 3, 3 } }, 5), { { 9, 9, 9 } }, { { 11, 12, 10 } }, seed);
  }
}

TEST(PlaceUpdate, AtTheBorderIsAsFoundAnew)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    const LabelVolume volume = Noise({ { 18, 19, 20 } }, static_cast<VertexId>(2 + seed % 3), seed);
    ExpectUpdatesOf(volume, { { 0, 0, 0 } }, { { 2, 3, 2 } }, seed);
    ExpectUpdatesOf(volume, { { 15, 17, 18 } }, { { 17, 18, 19 } }, seed);
  }
}

TEST(PlaceUpdate, OfMuchIsAsFoundAnew)
{
  ExpectUpdatesOf(Noise({ { 8, 8, 8 } }, 4, 1), { { 0, 0, 0 } }, { { 7, 7, 7 } }, 1);
}

TEST(PlaceUpdate, OfAWallThatIsCutMakesTwo)
{
  // Two cells above each other; a bar of a third one through their wall.
  LabelVolume volume =
    MakeImage({ { 40, 20, 10 } }, [](std::int32_t, std::int32_t, std::int32_t z) { return VertexId{ z < 5 ? 1 : 2 }; });
  auto                     walls = FindImageWalls(volume);
  std::vector<VoxelChange> changes;
  for (std::int32_t y = 0; y < 20; ++y)
  {
    changes.push_back({ { { 10, y, 5 } }, 2 });
    volume.vertices.Put(static_cast<std::size_t>((5 * 20 + y) * 40 + 10), 3);
  }
  UpdateImageWalls(volume, changes, walls);
  const auto count = std::count_if(walls.begin(), walls.end(), [](const ImageWall & wall) {
    return wall.cells == VertexPair{ { 1, 2 } };
  });
  EXPECT_EQ(count, 2);
  ExpectSameWalls(walls, FindImageWalls(volume));
}
