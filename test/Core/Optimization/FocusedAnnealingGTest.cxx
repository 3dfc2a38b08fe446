/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "KnownComplexProblem.h"
#include "Optimization/FocusedAnnealing.h"

#include <gtest/gtest.h>

using namespace tissue;
using namespace tissue_test;

TEST(FocusedAnnealing, RecoversAKnownComplexFromItsScrambledSelf)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    Problem problem(150, 20, seed);
    ASSERT_LT(problem.Adjacency4(), 0.92);
    AnnealingState state = problem.MakeState(seed);
    AnnealWhereWrong(state, FocusedAnnealingParameters(), problem.OneQuadruple());
    EXPECT_TRUE(FindViolations(problem.complex).empty());
    EXPECT_GT(problem.Adjacency4(), 0.98) << "seed " << seed;
  }
}

TEST(FocusedAnnealing, LeavesWhatIsRight)
{
  Problem        problem(60, 0, 1);
  AnnealingState state = problem.MakeState();
  AnnealWhereWrong(state, FocusedAnnealingParameters(), problem.OneQuadruple());
  EXPECT_EQ(problem.complex.GetTetrahedra(), problem.truth);
}

TEST(FocusedAnnealing, KeepsTheBestStateWhereItsTemperatureDestroysTheComplex)
{
  Problem                    problem(60, 3, 2);
  const double               before = problem.Adjacency4();
  FocusedAnnealingParameters hot;
  hot.initialTemperature = 1e6;
  hot.finalTemperature = 1e6;
  hot.numberOfRounds = 3;
  AnnealingState state = problem.MakeState();
  AnnealWhereWrong(state, hot, problem.OneQuadruple());
  EXPECT_EQ(problem.Adjacency4(), before);
  EXPECT_NEAR(state.energy.Total(), -ImageTermOnly().adjacencyWeight * before, 1e-9)
    << "the energy is that of the state";
}

TEST(FocusedAnnealing, EndsNoWorseAndSoonWhereTheStartIsWrongEverywhere)
{
  // A melted complex of 100 cells grows to thousands of tetrahedra, and every round would be slower.
  Problem        problem(100, 800, 4);
  const double   before = problem.Adjacency4();
  AnnealingState state = problem.MakeState();
  AnnealWhereWrong(state, FocusedAnnealingParameters(), problem.OneQuadruple());
  EXPECT_GE(problem.Adjacency4(), before);
  EXPECT_TRUE(FindViolations(problem.complex).empty());
}

TEST(FocusedAnnealing, SameSeedSameResult)
{
  const auto result = [](std::uint64_t seed) {
    Problem                    problem(150, 60, 4);
    AnnealingState             state = problem.MakeState(seed);
    FocusedAnnealingParameters few;
    few.numberOfRounds = 1;
    few.initialTemperature = 0.2;
    few.proposalsPerTetrahedron = 5;
    AnnealWhereWrong(state, few, problem.OneQuadruple());
    return problem.complex.GetTetrahedra();
  };
  EXPECT_EQ(result(1), result(1));
  EXPECT_TRUE(result(1) != result(2));
}
