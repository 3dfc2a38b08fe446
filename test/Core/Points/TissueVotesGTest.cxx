/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/TissueMask.h"
#include "Points/TissueVotes.h"
#include "RunBackwards.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace tissue;

const TissueGrid Grid = MakeTissueGrid({ { { 0.0, 0.0, 0.0 } }, { { 2.0, 2.0, 2.0 } } }, 0.1);

/** Eight cells that fill a cube: four in its lower half, the other four turned by some degrees over these, so that no
 * five meet but at the middle. */
std::vector<MetricSeed>
EightCells(double turn)
{
  std::vector<MetricSeed> seeds;
  for (int i = 0; i < 8; ++i)
  {
    const double x = i % 2 == 0 ? -0.5 : 0.5;
    const double y = i / 2 % 2 == 0 ? -0.5 : 0.5;
    const double t = i < 4 ? 0.0 : turn;
    MetricSeed   seed;
    seed.position = { { 1.0 + x - t * y, 1.0 + y + t * x, i < 4 ? 0.5 : 1.5 } };
    seeds.push_back(seed);
  }
  return seeds;
}

std::vector<JunctionVote>
Vote(const std::vector<MetricSeed> & seeds, double uncertainty, double shapeDoubt = 0.0,
     const Execution & execution = Execution())
{
  const TissueSamples samples = SampleMask({ Grid, std::vector<std::uint8_t>(Grid.NumberOfPoints(), 1) });
  return VoteOnJunctions(
    seeds, std::vector<double>(seeds.size(), 1.0), samples, Grid, uncertainty, shapeDoubt, execution);
}

double
ShareOf(const std::vector<JunctionVote> & votes, const VertexQuadruple & cells)
{
  const auto at = std::find_if(votes.begin(), votes.end(), [&](const JunctionVote & v) { return v.cells == cells; });
  return at == votes.end() ? 0.0 : at->share;
}
} // namespace

TEST(TissueVotes, AreAllOrNoneWhereNothingIsUncertain)
{
  const auto votes = Vote(EightCells(0.3), 0.0);
  EXPECT_FALSE(votes.empty());
  for (const JunctionVote & vote : votes)
  {
    EXPECT_DOUBLE_EQ(vote.share, 1.0);
    EXPECT_TRUE(std::is_sorted(vote.cells.begin(), vote.cells.end()));
  }
  // Two cells above each other and those beside them are at a side of the box together.
  EXPECT_EQ(ShareOf(votes, { { 0, 1, 2, 5 } }) + ShareOf(votes, { { 0, 1, 2, 6 } }), 1.0);
}

TEST(TissueVotes, TellWhatHangsByAThreadFromWhatDoesNot)
{
  // Of the eight cells of a cube, which four meet at its middle is anybody's guess.
  const auto even = Vote(EightCells(0.0), 0.03);
  EXPECT_GT(ShareOf(even, { { 0, 1, 2, 5 } }), 0.05);
  EXPECT_LT(ShareOf(even, { { 0, 1, 2, 5 } }), 0.95);
  const auto turned = Vote(EightCells(0.4), 0.03);
  EXPECT_GT(std::max(ShareOf(turned, { { 0, 1, 2, 5 } }), ShareOf(turned, { { 0, 1, 2, 6 } })), 0.9);
}

TEST(TissueVotes, DoubtOfShapesMakesSomeCellsRounder)
{
  auto         seeds = EightCells(0.4);
  const double least = 0.5 / 32.0;
  const auto   round = Vote(seeds, 0.0, 1.0);
  ASSERT_FALSE(round.empty());
  for (const JunctionVote & vote : round)
  {
    EXPECT_DOUBLE_EQ(vote.share, 1.0) << "balls are no rounder";
  }
  // Most cells are flat along x + y: the last of the tessellations are of balls.
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    seeds[i].metric =
      i % 3 == 0 ? Metric{ { 1.0, 0.0, 0.0, 1.0, 0.0, 1.0 } } : Metric{ { 1.5, 0.5, 0.0, 1.5, 0.0, 0.5 } };
  }
  const auto sure = Vote(seeds, 0.0);
  const auto balls = Vote(EightCells(0.4), 0.0);
  const auto doubted = Vote(seeds, 0.0, 1.0);
  for (const JunctionVote & vote : sure)
  {
    EXPECT_DOUBLE_EQ(vote.share, 1.0);
    EXPECT_GE(ShareOf(doubted, vote.cells), least) << "the first has them as they are";
  }
  for (const JunctionVote & vote : balls)
  {
    EXPECT_GE(ShareOf(doubted, vote.cells), least) << "the last has none";
  }
  EXPECT_TRUE(
    std::any_of(doubted.begin(), doubted.end(), [&](const JunctionVote & v) { return v.share < 1.0 - least; }));
}

TEST(TissueVotes, AreTheSameInAnyOrder)
{
  const auto a = Vote(EightCells(0.1), 0.05);
  const auto b = Vote(EightCells(0.1), 0.05, 0.0, Execution(tissue_test::RunBackwards));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_EQ(a[i].cells, b[i].cells);
    EXPECT_EQ(a[i].share, b[i].share);
    EXPECT_TRUE(i == 0 || a[i - 1].cells < a[i].cells);
  }
}

TEST(TissueVotes, CanBeAborted)
{
  const TissueSamples samples = SampleMask({ Grid, std::vector<std::uint8_t>(Grid.NumberOfPoints(), 1) });
  EXPECT_THROW(VoteOnJunctions(EightCells(0.0),
                               std::vector<double>(8, 1.0),
                               samples,
                               Grid,
                               0.03,
                               0.0,
                               Execution({}, [](double) { return false; })),
               Aborted);
}
