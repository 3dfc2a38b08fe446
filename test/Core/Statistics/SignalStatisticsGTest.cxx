/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "RunBackwards.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Statistics/TissueStatistics.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

namespace
{
using namespace tissue;

/** Two cells of 4 x 4 x 4 voxels of size 1, side by side along x, the first one from 0 to 4; none of the image is
 * exterior. */
struct TwoBlocks
{
  LabelVolume        labels;
  ImageGrid          grid;
  WallMesh           mesh;
  std::vector<float> values;

  TwoBlocks()
  {
    std::vector<VertexId> vertices;
    for (int i = 0; i < 8 * 4 * 4; ++i)
    {
      const int x = i % 8;
      vertices.push_back(x < 4 ? 1 : 2);
      values.push_back(static_cast<float>(x));
    }
    grid.size = { { 8, 4, 4 } };
    grid.origin = { { 0.5, 0.5, 0.5 } };
    labels.size = grid.size;
    labels.origin = grid.origin;
    labels.vertices = vertices;
    mesh = MakeVoxelWallMesh({ { 8, 4, 4 } }, vertices);
  }

  std::vector<CellSignal>
  Measure(double distance, const Execution & execution = Execution()) const
  {
    return MeasureSignal(labels, grid, values.data(), mesh, 3, distance, execution);
  }
};
} // namespace

TEST(SignalStatistics, MeanAndIntegralAreThoseOfTheVoxels)
{
  const TwoBlocks blocks;
  const auto      signals = blocks.Measure(1.0);
  ASSERT_EQ(3u, signals.size());
  EXPECT_DOUBLE_EQ(1.5, signals[1].mean);
  EXPECT_DOUBLE_EQ(5.5, signals[2].mean);
  EXPECT_DOUBLE_EQ(64 * 5.5, signals[2].integral);
  EXPECT_DOUBLE_EQ(64.0, signals[2].knownVolume);
  EXPECT_TRUE(std::isnan(signals[ExteriorVertex].mean));
}

TEST(SignalStatistics, NearTheWallsAreTheVoxelsWithinTheDistance)
{
  TwoBlocks blocks;
  // In each cell 8 voxels are not at a wall; they are half a voxel more from it than the others.
  for (std::size_t i = 0; i < blocks.values.size(); ++i)
  {
    const auto isInner = [](std::size_t at) { return at % 4 == 1 || at % 4 == 2; };
    blocks.values[i] = isInner(i % 8) && isInner(i / 8 % 4) && isInner(i / 32) ? 100.0f : 1.0f;
  }
  EXPECT_DOUBLE_EQ(1.0, blocks.Measure(0.5)[1].meanNearWalls);
  EXPECT_DOUBLE_EQ(1.0, blocks.Measure(1.4)[2].meanNearWalls);
  EXPECT_DOUBLE_EQ((56.0 + 800.0) / 64.0, blocks.Measure(1.5)[2].meanNearWalls);
  EXPECT_TRUE(std::isnan(blocks.Measure(0.4)[2].meanNearWalls));
}

TEST(SignalStatistics, TheImageMayHaveAGridOfItsOwn)
{
  TwoBlocks blocks;
  // Of voxels of a quarter, turned about z, from the middle of the first cell to beyond the second.
  blocks.grid.size = { { 16, 32, 16 } };
  blocks.grid.origin = { { 2.125, 0.125, 0.125 } };
  blocks.grid.steps = { { { { 0.0, 0.25, 0.0 } }, { { 0.25, 0.0, 0.0 } }, { { 0.0, 0.0, -0.25 } } } };
  blocks.grid.origin[2] = 3.875;
  blocks.values.assign(16 * 32 * 16, 2.0f);
  const auto signals = blocks.Measure(0.2);
  EXPECT_DOUBLE_EQ(32.0, signals[1].knownVolume);
  EXPECT_DOUBLE_EQ(64.0, signals[1].integral);
  EXPECT_DOUBLE_EQ(64.0, signals[2].knownVolume);
  EXPECT_DOUBLE_EQ(2.0, signals[2].meanNearWalls);
}

TEST(SignalStatistics, WhatIsNotFiniteIsNotKnown)
{
  TwoBlocks blocks;
  blocks.values[7] = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < blocks.values.size(); ++i)
  {
    blocks.values[i] = i % 8 < 4 ? std::numeric_limits<float>::quiet_NaN() : blocks.values[i];
  }
  const auto signals = blocks.Measure(1.0);
  EXPECT_TRUE(std::isnan(signals[1].mean));
  EXPECT_TRUE(std::isnan(signals[1].integral));
  EXPECT_EQ(0.0, signals[1].knownVolume);
  EXPECT_DOUBLE_EQ(63.0, signals[2].knownVolume);
  EXPECT_DOUBLE_EQ(64 * 5.5 - 7.0, signals[2].integral);
}

TEST(SignalStatistics, TheOrderOfTheWorkDoesNotMatter)
{
  TwoBlocks blocks;
  for (std::size_t i = 0; i < blocks.values.size(); ++i)
  {
    blocks.values[i] = 1.0f / static_cast<float>(3 + i);
  }
  const auto forwards = blocks.Measure(1.0);
  const auto backwards = blocks.Measure(1.0, Execution(tissue_test::RunBackwards));
  EXPECT_EQ(forwards[1].integral, backwards[1].integral);
  EXPECT_EQ(forwards[2].meanNearWalls, backwards[2].meanNearWalls);
}

TEST(SignalStatistics, AWallHasTheMeanByArea)
{
  const TwoBlocks blocks;
  const auto      means = MeasureOnWalls(blocks.mesh, 0.5, [](const Point & p) { return p[0] + 10.0 * p[1]; });
  for (std::size_t w = 0; w < means.size(); ++w)
  {
    const VertexPair & cells = blocks.mesh.walls[w].cells;
    const bool         isInner = cells[1] == 2;
    // The outer wall of the first cell: an end of 16, and four sides of 16 each, which are at 2 in the middle.
    const double x = isInner ? 4.0 : cells[0] == 1 ? 4.0 * 2.0 / 5.0 : (8.0 + 4.0 * 6.0) / 5.0;
    EXPECT_NEAR(x + 20.0, means[w], 1e-9);
  }
}

TEST(SignalStatistics, OfAWallThatIsNotKnownWhollyThePartThatIsCounts)
{
  const TwoBlocks blocks;
  const auto      unknown = MeasureOnWalls(blocks.mesh, 1.0, [](const Point &) { return UnknownStatistic; });
  EXPECT_TRUE(std::isnan(unknown.front()));
  const auto half =
    MeasureOnWalls(blocks.mesh, 1.0, [](const Point & p) { return p[2] < 2.0 ? 3.0 : UnknownStatistic; });
  EXPECT_DOUBLE_EQ(3.0, half.front());
}

TEST(SignalStatistics, WhatMakesNoSenseIsRefused)
{
  TwoBlocks blocks;
  EXPECT_THROW(blocks.Measure(-1.0), std::invalid_argument);
  EXPECT_THROW(blocks.Measure(UnknownStatistic), std::invalid_argument);
  blocks.grid.steps[2] = blocks.grid.steps[0];
  EXPECT_THROW(blocks.Measure(1.0), std::invalid_argument);
}
