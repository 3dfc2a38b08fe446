/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/PlaceDescent.h"
#include "Nerve/TestGeneralComplexes.h"
#include "Nerve/TestImages.h"

#include "TissueTessellationCore/Common/Random.h"

#include <gtest/gtest.h>

#include <map>

using namespace testing_nerve;

namespace
{
TissuePlaces
PlacesOf(const LabelVolume & volume)
{
  return { FindImageWalls(volume), FindCornerPlaces(volume, FindCrowdedBlocks(volume)) };
}

/** The places that a complex would have all right. */
TissuePlaces
PlacesOf(const GeneralComplex & complex)
{
  TissuePlaces places;
  for (const auto & edge : complex.FindEdges())
  {
    places.walls.push_back({ edge.vertices, 100, {} });
  }
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    if (complex.IsAlive(id))
    {
      VertexQuadruple t = complex.GetTetrahedron(id).vertices;
      std::sort(t.begin(), t.end());
      places.corners.push_back({ t, 1, {} });
    }
  }
  return places;
}

/** Votes on about half of the image's quadruples. */
std::vector<JunctionVote>
RandomVotes(const TissuePlaces & places, Random & random)
{
  std::vector<JunctionVote> votes;
  for (const CornerPlace & corner : places.corners)
  {
    const bool isRepeated = !votes.empty() && votes.back().cells == corner.cells;
    if (!isRepeated && random.Uniform() < 0.5)
    {
      votes.push_back({ corner.cells, random.Uniform() });
    }
  }
  return votes;
}

/** A move at a tetrahedron that is drawn; it may be illegal. */
MoveProposal
RandomProposal(const GeneralComplex & complex, Random & random)
{
  const auto id = static_cast<TetrahedronId>(random.Index(static_cast<std::size_t>(complex.TetrahedronIdBound())));
  if (!complex.IsAlive(id))
  {
    return { MoveVerdict::WrongDegree, {} };
  }
  const EdgeRing    ring = complex.GetRing({ id, 0, 1 });
  const std::size_t kind = random.Index(3);
  return kind == 0   ? SwapTriangle(complex, { id, 0 })
         : kind == 1 ? SplitEdge(complex, ring, 0, 1)
                     : CloseEdge(complex, { id, 0, 1 });
}

/** Whether the swap of a triangle of what a move has made lowers the energy. */
bool
IsLoweredBySwap(const GeneralComplex & complex, const PlaceEnergy & energy, const GeneralMove & inverse)
{
  for (const TetrahedronId id : inverse.removed)
  {
    for (int i = 0; i < 4; ++i)
    {
      const MoveProposal swap = SwapTriangle(complex, { id, i });
      if (swap && energy.Difference(complex, swap.move) < -1e-9)
      {
        return true;
      }
    }
  }
  return false;
}
} // namespace

TEST(TupleCounts, KeepWhatIsPutInWhileTheyGrow)
{
  TupleCounts<4> counts;
  for (VertexId i = 0; i < 5000; ++i)
  {
    counts[{ { i, i + 1, i + 2, 7 * i + 3 } }].wanted = i;
  }
  EXPECT_EQ(counts.GetEntries().size(), 5000u);
  for (VertexId i = 0; i < 5000; ++i)
  {
    EXPECT_EQ(counts.Get({ { i, i + 1, i + 2, 7 * i + 3 } }).wanted, i);
  }
  EXPECT_EQ(counts.Get({ { 1, 2, 3, 4 } }).wanted, 0);
  EXPECT_EQ(counts.GetEntries().size(), 5000u) << "asking makes no entry";
}

TEST(PlaceEnergy, CountsLargeWallsAndTheLargestOfEachTwoCells)
{
  TissuePlaces places;
  places.walls = {
    { { { 0, 1 } }, 50, {} }, { { { 0, 1 } }, 12, {} }, { { { 0, 1 } }, 9, {} }, { { { 0, 2 } }, 1, {} }
  };
  const PlaceEnergy energy(places, PlacePreferences::WallsFirst(), GeneralComplex(3));
  EXPECT_EQ(energy.GetWalls().Get({ { 0, 1 } }).wanted, 2);
  EXPECT_EQ(energy.GetWalls().Get({ { 0, 2 } }).wanted, 1);
  EXPECT_EQ(energy.Total(), 2.0 * 3);
}

TEST(PlaceEnergy, FirstCornerOfFourCellsCountsMoreThanFurtherOnes)
{
  const auto                preferences = PlacePreferences::JunctionsFirst();
  const double              repeated = preferences.repeatedCorner;
  constexpr VertexQuadruple cells{ { 0, 1, 2, 3 } };
  TissuePlaces              places;
  places.corners = { { cells, 1, {} } };
  EXPECT_DOUBLE_EQ(PlaceEnergy(places, preferences, GeneralComplex(5)).CostOfTetrahedron(cells), -1.0);
  const GeneralComplex two = FourCells(5);
  EXPECT_DOUBLE_EQ(PlaceEnergy(places, preferences, two).CostOfTetrahedron(cells), repeated) << "one is wanted";
  EXPECT_DOUBLE_EQ(PlaceEnergy(places, preferences, two).CostWithoutTetrahedron(cells), -repeated);
  EXPECT_DOUBLE_EQ(PlaceEnergy(places, preferences, two).CostOfTetrahedron({ { 0, 1, 2, 4 } }), 1.0) << "do not meet";
  EXPECT_DOUBLE_EQ(PlaceEnergy({}, preferences, two).CostOfTetrahedron(cells), 1.0) << "do not meet, and are there";
  places.corners = { 3, { cells, 1, {} } };
  EXPECT_DOUBLE_EQ(PlaceEnergy(places, preferences, two).CostOfTetrahedron(cells), -repeated) << "three are wanted";
}

TEST(PlacePreferences, NoPreferencePaysForCopiesOfAWall)
{
  // A missing group of four between two copies of a wall: two walls too many, and its second corner.
  for (const auto & preferences : { PlacePreferences::WallsFirst(), PlacePreferences::JunctionsFirst() })
  {
    EXPECT_GT(2.0 * preferences.wallWeight + preferences.repeatedCorner, 1.0);
  }
}

TEST(PlaceEnergy, DifferenceIsThatOfTheTotals)
{
  const LabelVolume volume = Noise({ { 5, 5, 5 } }, 9, 3);
  const auto        places = PlacesOf(volume);
  Random            random(1);
  struct Case
  {
    PlacePreferences          preferences;
    std::vector<JunctionVote> votes;
  };
  for (const auto & [preferences, votes] : { Case{ PlacePreferences::WallsFirst(), {} },
                                             Case{ PlacePreferences::JunctionsFirst(), {} },
                                             Case{ PlacePreferences::ByVotes(), RandomVotes(places, random) } })
  {
    GeneralComplex complex = NerveOf(volume).complex;
    PlaceEnergy    energy(places, preferences, complex, votes);
    int            legal = 0;
    for (int i = 0; i < 2000; ++i)
    {
      const MoveProposal proposal = RandomProposal(complex, random);
      if (proposal)
      {
        ++legal;
        const double before = energy.Total();
        const double difference = energy.Difference(complex, proposal.move);
        energy.Account(complex, proposal.move);
        complex.Apply(proposal.move);
        ASSERT_NEAR(energy.Total(), before + difference, 1e-9);
      }
    }
    EXPECT_GT(legal, 200);
    EXPECT_NEAR(energy.Total(), PlaceEnergy(places, preferences, complex, votes).Total(), 1e-9);
  }
}

TEST(PlaceEnergy, VotesDecideOnTheFirstCornerOfFourCellsInPlaceOfTheImage)
{
  TissuePlaces places;
  places.corners = { { { { 0, 1, 2, 3 } }, 5, {} }, { { { 0, 1, 2, 4 } }, 5, {} } };
  GeneralComplex    complex = FourCells(5);
  const PlaceEnergy energy(places, PlacePreferences::ByVotes(), complex, { { { { 0, 1, 2, 3 } }, 0.5 } });
  const double      least = PlacePreferences::ByVotes().leastVote;
  EXPECT_DOUBLE_EQ(energy.CostOfTetrahedron({ { 2, 4, 0, 1 } }), least) << "no votes";
  EXPECT_DOUBLE_EQ(energy.CostOfTetrahedron({ { 0, 1, 2, 3 } }), least) << "there are two";
  EXPECT_DOUBLE_EQ(energy.CostWithoutTetrahedron({ { 0, 1, 2, 3 } }), -least) << "one stays";
  const double walls = 6 * PlacePreferences::ByVotes().wallWeight;
  EXPECT_DOUBLE_EQ(energy.Total(), walls + 2 * least - 0.5);
  const PlaceEnergy before(places, PlacePreferences::ByVotes(), GeneralComplex(5), { { { { 0, 1, 2, 3 } }, 0.5 } });
  EXPECT_DOUBLE_EQ(before.CostOfTetrahedron({ { 3, 1, 2, 0 } }), least - 0.5);
}

TEST(PlaceDescent, FindsBackFromNearlyEachMove)
{
  const GeneralComplex wanted = NerveOf(Bricks({ { 3, 3, 2 } }, 6)).complex;
  const auto           places = PlacesOf(wanted);
  int                  moves = 0;
  int                  found = 0;
  for (TetrahedronId id = 0; id < wanted.TetrahedronIdBound(); ++id)
  {
    const EdgeRing ring = wanted.GetRing({ id, 0, 2 });
    for (const MoveProposal & proposal : { SwapTriangle(wanted, { id, id % 4 }), SplitEdge(wanted, ring, 0, 1) })
    {
      if (!proposal)
      {
        continue;
      }
      ++moves;
      GeneralComplex complex = wanted;
      complex.Apply(proposal.move);
      const auto result = Descend(complex, places, PlacePreferences::WallsFirst());
      EXPECT_GT(result.energyBefore, 0.0);
      found += result.energyAfter == 0.0 && CountEdges(complex) == CountEdges(wanted) ? 1 : 0;
    }
  }
  EXPECT_GT(moves, 100);
  EXPECT_GT(found, 0.98 * moves) << "few are caught on the way";
}

TEST(PlaceDescent, LeavesNoMoveThatCostsNothingAndOpensTheWayToABetterOne)
{
  int free = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const LabelVolume volume = Noise({ { 5, 5, 5 } }, static_cast<VertexId>(6 + seed), seed);
    const auto        places = PlacesOf(volume);
    const auto        preferences = seed % 2 ? PlacePreferences::WallsFirst() : PlacePreferences::JunctionsFirst();
    GeneralComplex    complex = NerveOf(volume).complex;
    Descend(complex, places, preferences);
    PlaceEnergy energy(places, preferences, complex);
    Random      random(seed);
    for (int i = 0; i < 5000; ++i)
    {
      const MoveProposal first = RandomProposal(complex, random);
      if (!first || std::abs(energy.Difference(complex, first.move)) > 1e-9)
      {
        continue;
      }
      ++free;
      energy.Account(complex, first.move);
      const GeneralMove inverse = complex.Apply(first.move);
      EXPECT_FALSE(IsLoweredBySwap(complex, energy, inverse));
      energy.Account(complex, inverse);
      complex.Apply(inverse);
    }
  }
  EXPECT_GT(free, 0) << "nothing was tried";
}

TEST(PlaceDescent, FollowsVotesAgainstTheImage)
{
  // All votes are for what one move makes of the image's complex.
  const GeneralComplex image = NerveOf(Bricks({ { 3, 3, 2 } }, 6)).complex;
  int                  moves = 0;
  int                  found = 0;
  for (TetrahedronId id = 0; id < image.TetrahedronIdBound(); ++id)
  {
    const MoveProposal proposal = SwapTriangle(image, { id, id % 4 });
    if (!proposal)
    {
      continue;
    }
    ++moves;
    GeneralComplex voted = image;
    voted.Apply(proposal.move);
    std::map<VertexQuadruple, double> shares;
    for (const CornerPlace & corner : PlacesOf(voted).corners)
    {
      shares[corner.cells] = 1.0;
    }
    std::vector<JunctionVote> votes;
    for (const auto & [cells, share] : shares)
    {
      votes.push_back({ cells, share });
    }
    GeneralComplex complex = image;
    const auto     result = Descend(complex, PlacesOf(image), PlacePreferences::ByVotes(), votes);
    EXPECT_LT(result.energyAfter, result.energyBefore);
    const PlaceEnergy ofVoted(PlacesOf(image), PlacePreferences::ByVotes(), voted, votes);
    found += result.energyAfter <= ofVoted.Total() + 1e-9 ? 1 : 0;
  }
  EXPECT_GT(moves, 30);
  EXPECT_GT(found, 0.75 * moves) << "some are caught on the way";
}

TEST(PlaceDescent, KeepsLinksAndLowersTheEnergy)
{
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    const LabelVolume volume = Noise({ { 6, 6, 5 } }, static_cast<VertexId>(4 + seed), seed);
    GeneralComplex    complex = NerveOf(volume).complex;
    const auto        links = EulerCharacteristics(complex);
    const auto        violations = FindViolations(complex);
    const auto        places = PlacesOf(volume);
    Random            random(seed);
    for (const auto & votes : { std::vector<JunctionVote>(), RandomVotes(places, random) })
    {
      const auto preferences = !votes.empty() ? PlacePreferences::ByVotes()
                               : seed % 2     ? PlacePreferences::WallsFirst()
                                              : PlacePreferences::JunctionsFirst();
      const auto result = Descend(complex, places, preferences, votes);
      EXPECT_LE(result.energyAfter, result.energyBefore);
      EXPECT_EQ(EulerCharacteristics(complex), links);
      EXPECT_EQ(FindViolations(complex), violations);
    }
  }
}

TEST(PlaceDescent, TakesOutWhatDiagonalsBroughtIn)
{
  // Eight cubes around a corner: the subdivision's diagonals join cells that share no face.
  const LabelVolume volume = Bricks({ { 3, 3, 3 } }, 4, false);
  GeneralComplex    complex = NerveOf(volume).complex;
  const auto        places = PlacesOf(volume);
  const auto        before = CountEdges(complex).size();
  Descend(complex, places, PlacePreferences::WallsFirst());
  EXPECT_LE(CountEdges(complex).size(), before);
  EXPECT_TRUE(FindViolations(complex).empty());
}
