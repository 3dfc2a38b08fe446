/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/LocalSpacing.h"
#include "Optimization/EnergyFunction.h"
#include "RandomMoves.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace tissue_test;

namespace
{
/** The cell 5 inside of the cells 1 to 4, at right angles at cell 1. */
std::vector<Point>
FiveCells()
{
  return { NoPosition, { { 0, 0, 0 } }, { { 3, 0, 0 } }, { { 0, 3, 0 } }, { { 0, 0, 3 } }, { { 0.5, 0.5, 0.5 } } };
}

/** Weights of which only the given ones are not 0. */
EnergyParameters
Weights(double adjacency, double neighbor, double length)
{
  EnergyParameters parameters;
  parameters.adjacencyWeight = adjacency;
  parameters.neighborWeight = neighbor;
  parameters.lengthWeight = length;
  return parameters;
}
} // namespace

TEST(EnergyFunction, DefaultWeightsAreThoseOfThePaper)
{
  const EnergyParameters parameters;
  EXPECT_EQ(parameters.adjacencyWeight, 8.0);
  EXPECT_EQ(parameters.neighborWeight, 0.05);
  EXPECT_EQ(parameters.lengthWeight, 0.5);
  EXPECT_EQ(parameters.unitLength, 1.0);
  EXPECT_EQ(parameters.delaunayWeight, 0.0);
}

TEST(EnergyFunction, ImageTermIsTheJaccardIndex)
{
  const auto             centers = FiveCells();
  const AdjacencyComplex complex = DelaunayComplex(centers);
  ASSERT_EQ(complex.NumberOfTetrahedra(), 8u);
  JunctionSet junctions = JunctionsOf(complex, centers);
  junctions.junctions.erase(junctions.junctions.begin(), junctions.junctions.begin() + 3);
  Junction more;
  more.cells = { { 1, 2, 3, 4 } };
  junctions.junctions.push_back(more);
  // 5 in common of 8 and 6
  const ReferenceAdjacency reference(junctions);
  const EnergyFunction     energy(complex, centers, &reference, Weights(8.0, 0.0, 0.0));
  EXPECT_NEAR(energy.Total(), -8.0 * 5.0 / 9.0, 1e-12);
  EXPECT_EQ(EnergyFunction(complex, centers, nullptr, Weights(8.0, 0.0, 0.0)).Total(), 0.0);
}

TEST(EnergyFunction, PriorTermByHand)
{
  const auto             centers = FiveCells();
  const AdjacencyComplex complex = DelaunayComplex(centers);
  // Four epidermal cells have 5 neighbours, the exterior counted, instead of 9 + 1; the inner one has 4 instead of 13.
  const double expected = 0.05 * (4 * 25.0 + 81.0) / 5.0;
  EXPECT_NEAR(EnergyFunction(complex, centers, nullptr, Weights(0.0, 0.05, 0.0)).Total(), expected, 1e-12);
}

TEST(EnergyFunction, LengthTermByHand)
{
  const auto             centers = FiveCells();
  const AdjacencyComplex complex = DelaunayComplex(centers);
  // Every tetrahedron, to the exterior or not, has a side of the four outer cells: each of these has an edge 3 sqrt(2).
  const double expected = 0.5 * 3.0 * std::sqrt(2.0);
  EXPECT_NEAR(EnergyFunction(complex, centers, nullptr, Weights(0.0, 0.0, 0.5)).Total(), expected, 1e-12);
  EnergyParameters parameters = Weights(0.0, 0.0, 0.5);
  parameters.unitLength = 3.0;
  EXPECT_NEAR(EnergyFunction(complex, centers, nullptr, parameters).Total(), expected / 3.0, 1e-12);
  parameters.unitLength = 0.0;
  EXPECT_NEAR(EnergyFunction(complex, centers, nullptr, parameters).Total(),
              expected / MedianSpacing(LocalSpacings(complex, centers)),
              1e-12);
}

TEST(EnergyFunction, DeviationFromDelaunayIsItsSumACell)
{
  const auto              centers = RandomCenters(40, 7);
  const AdjacencyComplex  complex = DelaunayComplex(centers);
  const DelaunayDeviation deviation(centers, LocalSpacings(complex, centers));
  double                  sum = 0.0;
  for (const VertexQuadruple & t : complex.GetTetrahedra())
  {
    sum += deviation.Of(t);
  }
  EnergyParameters parameters = Weights(0.0, 0.0, 0.0);
  parameters.delaunayWeight = 30.0;
  EXPECT_NE(sum, 0.0);
  EXPECT_NEAR(EnergyFunction(complex, centers, nullptr, parameters).Total(), 30.0 * sum / 40.0, 1e-12);
}

TEST(EnergyFunction, TermsAddUp)
{
  const auto               centers = RandomCenters(30, 1);
  AdjacencyComplex         complex = DelaunayComplex(centers);
  const ReferenceAdjacency reference(JunctionsOf(complex, centers));
  Random                   random(1);
  Scramble(complex, LocalOperations(complex, centers, Legality::Combinatorial), 20, random);
  const auto total = [&](const EnergyParameters & parameters) {
    return EnergyFunction(complex, centers, &reference, parameters).Total();
  };
  EXPECT_NEAR(total(Weights(8.0, 0.05, 0.5)),
              total(Weights(8.0, 0.0, 0.0)) + total(Weights(0.0, 0.05, 0.0)) + total(Weights(0.0, 0.0, 0.5)),
              1e-12);
}

TEST(EnergyFunction, DifferenceIsThatOfTheTotalRecomputedOverRandomMoves)
{
  // Without a reference, with one, with it and the deviation from Delaunay, with that alone.
  for (const int kind : { 0, 1, 2, 3 })
  {
    const bool               withReference = kind == 1 || kind == 2;
    const auto               centers = RandomCenters(25, 2);
    AdjacencyComplex         complex = DelaunayComplex(centers);
    const ReferenceAdjacency reference(JunctionsOf(complex, centers));
    const LocalOperations    operations(complex, centers, Legality::Combinatorial);
    EnergyParameters         parameters;
    parameters.delaunayWeight = kind >= 2 ? 1.0 : 0.0;
    parameters.unitLength = kind >= 2 ? 0.0 : 1.0;
    EnergyFunction energy(complex, centers, withReference ? &reference : nullptr, parameters);
    Random         random(2);
    double         largest = 0.0;
    for (int done = 0; done < 3000;)
    {
      const Proposal move = RandomMove(complex, operations, random);
      if (!move)
      {
        continue;
      }
      const double before = energy.Total();
      const double difference = energy.Difference(move.replacement);
      EXPECT_EQ(energy.Total(), before) << "a difference changes nothing";
      energy.Update(move.replacement);
      const Replacement inverse = complex.Apply(move.replacement);
      EnergyFunction    recomputed = energy;
      recomputed.Recompute();
      const double fresh = recomputed.Total();
      ASSERT_NEAR(energy.Total(), fresh, 1e-9) << "after move " << done;
      ASSERT_NEAR(difference, fresh - before, 1e-9) << "move " << done;
      ASSERT_NEAR(energy.Difference(inverse), -difference, 1e-9) << "back from move " << done;
      largest = std::max(largest, std::abs(difference));
      ++done;
    }
    EXPECT_GT(largest, 0.01) << "the moves matter";
  }
}

TEST(EnergyFunction, RecomputeCountsWhatItWasNotToldOf)
{
  const auto       centers = RandomCenters(25, 3);
  AdjacencyComplex complex = DelaunayComplex(centers);
  EnergyFunction   energy(complex, centers, nullptr, EnergyParameters());
  Random           random(3);
  Scramble(complex, LocalOperations(complex, centers, Legality::Combinatorial), 20, random);
  const double fresh = EnergyFunction(complex, centers, nullptr, EnergyParameters()).Total();
  EXPECT_NE(energy.Total(), fresh);
  energy.Recompute();
  EXPECT_EQ(energy.Total(), fresh);
}
