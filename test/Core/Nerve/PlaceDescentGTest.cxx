/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/PlaceDescent.h"
#include "Nerve/TestGeneralComplexes.h"
#include "Nerve/TestImages.h"

#include <gtest/gtest.h>

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

TEST(PlaceEnergy, DifferenceIsThatOfTheTotals)
{
  const LabelVolume volume = Noise({ { 5, 5, 5 } }, 9, 3);
  const auto        places = PlacesOf(volume);
  GeneralComplex    complex = NerveOf(volume).complex;
  Random            random(1);
  PlaceEnergy       energy(places, PlacePreferences::WallsFirst(), complex);
  int               legal = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const auto id = static_cast<TetrahedronId>(random.Index(static_cast<std::size_t>(complex.TetrahedronIdBound())));
    if (!complex.IsAlive(id))
    {
      continue;
    }
    const EdgeRing     ring = complex.GetRing({ id, 0, 1 });
    const std::size_t  kind = random.Index(3);
    const MoveProposal proposal = kind == 0   ? SwapTriangle(complex, { id, 0 })
                                  : kind == 1 ? SplitEdge(complex, ring, 0, 1)
                                              : CloseEdge(complex, { id, 0, 1 });
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
  EXPECT_NEAR(energy.Total(), PlaceEnergy(places, PlacePreferences::WallsFirst(), complex).Total(), 1e-9);
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

TEST(PlaceDescent, KeepsLinksAndLowersTheEnergy)
{
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    const LabelVolume volume = Noise({ { 6, 6, 5 } }, static_cast<VertexId>(4 + seed), seed);
    GeneralComplex    complex = NerveOf(volume).complex;
    const auto        links = EulerCharacteristics(complex);
    const auto        violations = FindViolations(complex);
    const auto        result = Descend(
      complex, PlacesOf(volume), seed % 2 ? PlacePreferences::WallsFirst() : PlacePreferences::JunctionsFirst());
    EXPECT_LE(result.energyAfter, result.energyBefore);
    EXPECT_EQ(EulerCharacteristics(complex), links);
    EXPECT_EQ(FindViolations(complex), violations);
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
