/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/KuhnFragments.h"
#include "Nerve/TestImages.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace testing_nerve;

namespace
{
/** The pieces of each vertex but the exterior, by flooding over the edges of the subdivision. */
std::map<VertexId, int>
CountPieces(const LabelVolume & volume)
{
  const auto index = [&](const VoxelIndex & p) { return (p[2] * volume.size[1] + p[1]) * volume.size[0] + p[0]; };
  std::set<std::int32_t>  seen;
  std::map<VertexId, int> pieces;
  for (std::int32_t start = 0; start < static_cast<std::int32_t>(volume.vertices.size()); ++start)
  {
    const VertexId vertex = volume.vertices[static_cast<std::size_t>(start)];
    if (vertex == ExteriorVertex || !seen.insert(start).second)
    {
      continue;
    }
    ++pieces[vertex];
    std::vector<VoxelIndex> open{
      { { start % volume.size[0], start / volume.size[0] % volume.size[1], start / volume.size[0] / volume.size[1] } }
    };
    while (!open.empty())
    {
      const VoxelIndex p = open.back();
      open.pop_back();
      for (int step = -7; step <= 7; ++step)
      {
        const int        s = std::abs(step);
        const int        sign = step < 0 ? -1 : 1;
        const VoxelIndex q{ { p[0] + sign * (s & 1), p[1] + sign * (s >> 1 & 1), p[2] + sign * (s >> 2 & 1) } };
        if (volume.At(q[0], q[1], q[2]) == vertex && seen.insert(index(q)).second)
        {
          open.push_back(q);
        }
      }
    }
  }
  return pieces;
}
} // namespace

TEST(KuhnFragments, OfNoiseLeaveEachVertexOnePiece)
{
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    LabelVolume       volume = Noise({ { 6, 5, 4 } }, static_cast<VertexId>(3 + seed % 6), seed);
    const LabelVolume image = volume;
    const auto        vertices = NumberOfVertices(volume);
    const Fragments   fragments = FindFragments(volume, vertices, 3);
    int               pieces = 0;
    for (const auto & ofVertex : CountPieces(volume))
    {
      pieces += ofVertex.second - 1;
    }
    EXPECT_EQ(fragments.fragments.size(), static_cast<std::size_t>(pieces)) << seed;
    Relabel(volume, fragments.ofLarge);
    Relabel(volume, fragments.ofSmall);
    for (const auto & ofVertex : CountPieces(volume))
    {
      EXPECT_EQ(ofVertex.second, 1) << seed << ": vertex " << ofVertex.first;
    }
    for (std::size_t i = 0; i < image.vertices.size(); ++i)
    {
      EXPECT_TRUE(image.vertices[i] != ExteriorVertex || volume.vertices[i] == ExteriorVertex);
    }
    for (const LabelVolume * ofVoxels : { &image, static_cast<const LabelVolume *>(&volume) })
    {
      const auto boxes = FindVoxelBoxes(*ofVoxels, static_cast<std::size_t>(fragments.numberOfVertices));
      for (std::size_t v = 0; v < boxes.size(); ++v)
      {
        VoxelBox all = fragments.boxes[v];
        if (!boxes[v].IsEmpty())
        {
          all.Add(boxes[v].least);
          all.Add(boxes[v].most);
        }
        EXPECT_EQ(all.NumberOfVoxels(), fragments.boxes[v].NumberOfVoxels()) << seed << ": vertex " << v;
      }
    }
  }
}

TEST(KuhnFragments, LargeOnesAreVerticesAndSmallOnesGoToTheNeighbourOfMostFaces)
{
  // A row of cells 1 and 2, with a fragment of 1 within 2 and one of two voxels at the end.
  LabelVolume     volume = MakeImage({ { 12, 1, 1 } }, [](std::int32_t x, std::int32_t, std::int32_t) -> VertexId {
    return x < 4 || x == 6 || x > 9 ? 1 : 2;
  });
  const Fragments fragments = FindFragments(volume, 3, 2);
  ASSERT_EQ(fragments.fragments.size(), 3u) << "two of cell 1, one of cell 2";
  EXPECT_EQ(fragments.numberOfVertices, 5);
  Relabel(volume, fragments.ofLarge);
  Relabel(volume, fragments.ofSmall);
  EXPECT_EQ(volume.vertices, (std::vector<VertexId>{ 1, 1, 1, 1, 3, 3, 2, 2, 2, 2, 4, 4 }));
}

TEST(KuhnFragments, OfSoundCellsAreNone)
{
  const LabelVolume volume = Bricks({ { 3, 3, 2 } }, 4);
  EXPECT_TRUE(FindFragments(volume, NumberOfVertices(volume)).fragments.empty());
}
