/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/HandleCutting.h"
#include "Nerve/KuhnFragments.h"
#include "Nerve/TestImages.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace testing_nerve;

namespace
{
/** Every vertex one piece, as CutHandles() wants it. */
LabelVolume
WithoutFragments(LabelVolume volume, VertexId & numberOfVertices)
{
  const Fragments fragments = FindFragments(volume, numberOfVertices);
  Relabel(volume, fragments.ofLarge);
  Relabel(volume, fragments.ofSmall);
  numberOfVertices = fragments.numberOfVertices;
  return volume;
}

HandleCuts
CutHandlesOf(LabelVolume & volume, VertexId numberOfVertices)
{
  return CutHandles(volume,
                    FindEulerCharacteristics(volume, numberOfVertices),
                    FindVoxelBoxes(volume, static_cast<std::size_t>(numberOfVertices)));
}

/** A torus around the third axis, in exterior. */
LabelVolume
Torus(double radius, double thickness)
{
  return MakeImage({ { 40, 40, 20 } }, [=](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
    const double fromRing = std::hypot(x - 19.7, y - 19.6) - radius;
    return std::hypot(fromRing, z - 9.8) < thickness ? 1 : ExteriorVertex;
  });
}
} // namespace

TEST(HandleCutting, CountsAsTheBoundaryDoes)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const LabelVolume volume = Noise({ { 7, 6, 5 } }, static_cast<VertexId>(2 + seed % 4), seed);
    const auto        vertices = NumberOfVertices(volume);
    const auto        characteristics = FindEulerCharacteristics(volume, vertices);
    for (VertexId v = 1; v < vertices; ++v)
    {
      EXPECT_EQ(2 * characteristics[v], BoundaryEulerCharacteristic(volume, v)) << seed << ": vertex " << v;
    }
  }
}

TEST(HandleCutting, OfAHandleOfOneVoxelTakesOne)
{
  // A brick with an arch of single voxels on it.
  LabelVolume volume = MakeImage({ { 14, 14, 14 } }, [](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
    const bool isInBrick = x > 1 && x < 12 && y > 1 && y < 12 && z > 1 && z < 8;
    const bool isInArch = y == 6 && x > 3 && x < 9 && z >= 8 && z < 11 && (x == 4 || x == 8 || z == 10);
    return isInBrick || isInArch ? 1 : ExteriorVertex;
  });
  const LabelVolume image = volume;
  ASSERT_EQ(FindEulerCharacteristics(image, 2)[1], 0);
  const HandleCuts cuts = CutHandlesOf(volume, 2);
  ASSERT_EQ(cuts.cells.size(), 1u);
  EXPECT_EQ(cuts.cells[0].handlesBefore, 1);
  EXPECT_EQ(cuts.cells[0].handlesLeft, 0);
  EXPECT_EQ(cuts.cells[0].numberOfVoxels, 1);
  EXPECT_EQ(FindEulerCharacteristics(volume, 2)[1], 1);
  ASSERT_EQ(cuts.changes.size(), 1u);
  const VoxelIndex & p = cuts.changes[0].voxel;
  EXPECT_EQ(cuts.changes[0].before, 1);
  EXPECT_EQ(image.At(p[0], p[1], p[2]), 1);
  EXPECT_EQ(volume.At(p[0], p[1], p[2]), ExteriorVertex);
}

TEST(HandleCutting, OfATorusIsASheetAcross)
{
  LabelVolume      thin = Torus(14, 2.0);
  const HandleCuts cuts = CutHandlesOf(thin, 2);
  ASSERT_EQ(cuts.cells.size(), 1u);
  EXPECT_EQ(cuts.cells[0].handlesLeft, 0);
  EXPECT_GT(cuts.cells[0].numberOfVoxels, 8);
  EXPECT_LT(cuts.cells[0].numberOfVoxels, 25) << "about what is across it";
  EXPECT_EQ(FindEulerCharacteristics(thin, 2)[1], 1);
}

TEST(HandleCutting, LeavesAScaffold)
{
  // Bars of two voxels, with a bar's length of air between: to make a ball of them takes most of them.
  LabelVolume scaffold = MakeImage({ { 18, 18, 18 } }, [](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
    const auto isAtBar = [](std::int32_t i) { return i % 4 < 2; };
    const int  bars = isAtBar(x) + isAtBar(y) + isAtBar(z);
    return bars > 1 ? 1 : ExteriorVertex;
  });
  const LabelVolume image = scaffold;
  const HandleCuts  none = CutHandlesOf(scaffold, 2);
  ASSERT_EQ(none.cells.size(), 1u);
  EXPECT_GT(none.cells[0].handlesBefore, 100);
  EXPECT_EQ(none.cells[0].handlesLeft, none.cells[0].handlesBefore);
  EXPECT_TRUE(none.changes.empty());
  EXPECT_EQ(scaffold.vertices, image.vertices);
}

TEST(HandleCutting, LeavesCavities)
{
  LabelVolume shell = MakeImage({ { 16, 16, 16 } }, [](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
    const double r = std::hypot(x - 7.5, y - 7.5, z - 7.5);
    return r < 3 ? 2 : r < 7 ? 1 : ExteriorVertex;
  });
  const LabelVolume image = shell;
  EXPECT_EQ(FindEulerCharacteristics(shell, 3), (std::vector<std::int32_t>{ 0, 2, 1 }));
  EXPECT_TRUE(CutHandlesOf(shell, 3).cells.empty());
  EXPECT_EQ(shell.vertices, image.vertices);
}

TEST(HandleCutting, OfNoiseIsNoWorseThanBefore)
{
  std::int32_t before = 0;
  std::int32_t left = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
  {
    const LabelVolume noise = Noise({ { 9, 8, 7 } }, static_cast<VertexId>(3 + seed % 6), seed);
    auto              vertices = NumberOfVertices(noise);
    LabelVolume       volume = WithoutFragments(noise, vertices);
    for (const HandleCut & cut : CutHandlesOf(volume, vertices).cells)
    {
      EXPECT_GT(cut.handlesBefore, 0);
      before += cut.handlesBefore;
      left += cut.handlesLeft;
    }
    EXPECT_EQ(NumberOfVertices(volume), vertices) << "no cell is lost";
  }
  EXPECT_LT(left, before);
}
