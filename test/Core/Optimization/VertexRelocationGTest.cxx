/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "KnownComplexProblem.h"
#include "Optimization/VertexRelocation.h"

#include <gtest/gtest.h>

using namespace tissue;
using namespace tissue_test;

namespace
{
/** The truth, and as the start the complex in which some cells are where others are: the first to the opposite side of
 * the cube. */
struct MisplacedCells : Problem
{
  MisplacedCells(int numberOfCells, int numberOfMisplaced, std::uint64_t seed)
    : Problem(numberOfCells, 0, seed)
  {
    std::vector<Point> moved = centers;
    for (int v = 1; v <= numberOfMisplaced; ++v)
    {
      for (double & x : moved[v])
      {
        x = x < 0.5 ? x + 0.45 : x - 0.45;
      }
    }
    complex = DelaunayComplex(moved);
  }

  std::size_t
  Relocate(const VertexRelocationParameters & parameters = VertexRelocationParameters())
  {
    AnnealingState state = MakeState();
    return RelocateVertices(state, parameters, OneQuadruple());
  }
};
} // namespace

TEST(VertexRelocation, BringsAMisplacedCellBackAmongItsNeighbors)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    MisplacedCells problem(150, 1, seed);
    ASSERT_LT(problem.Adjacency4(), 0.95) << "seed " << seed;
    EXPECT_GE(problem.Relocate(), 1u) << "seed " << seed;
    EXPECT_TRUE(FindViolations(problem.complex).empty());
    // Recorded: .98 to 1.
    EXPECT_GT(problem.Adjacency4(), 0.97) << "seed " << seed;
  }
}

TEST(VertexRelocation, LeavesWhatIsRight)
{
  Problem        problem(60, 0, 1);
  AnnealingState state = problem.MakeState();
  EXPECT_EQ(RelocateVertices(state, VertexRelocationParameters(), problem.OneQuadruple()), 0u);
  EXPECT_EQ(problem.complex.GetTetrahedra(), problem.truth);
}

TEST(VertexRelocation, UndoesWhatDoesNotLowerTheEnergy)
{
  MisplacedCells             problem(100, 3, 2);
  const auto                 before = problem.complex.GetTetrahedra();
  VertexRelocationParameters nowhere;
  nowhere.numberOfPlaces = 0;
  EXPECT_EQ(problem.Relocate(nowhere), 0u);
  EXPECT_EQ(problem.complex.GetTetrahedra(), before);
}

TEST(VertexRelocation, TriesNoMoreVerticesThanItsShare)
{
  MisplacedCells             problem(150, 20, 3);
  VertexRelocationParameters one;
  one.largestShare = 0.0;
  EXPECT_LE(problem.Relocate(one), 1u);
}

TEST(VertexRelocation, StopsOnRequest)
{
  MisplacedCells problem(100, 3, 2);
  AnnealingState state = problem.MakeState();
  EXPECT_THROW(
    RelocateVertices(
      state, VertexRelocationParameters(), problem.OneQuadruple(), Execution({}, [](double) { return false; })),
    Aborted);
  EXPECT_TRUE(FindViolations(problem.complex).empty());
}
