/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/ExactPredicates.h"
#include "RandomMoves.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
/** V - E + F - T, with F = 2 T in a closed complex. */
long
EulerCharacteristic(const AdjacencyComplex & complex)
{
  return static_cast<long>(complex.NumberOfVertices()) - static_cast<long>(complex.NumberOfEdges()) +
         static_cast<long>(complex.NumberOfTetrahedra());
}

std::int64_t
NumberOfInvertedCells(const AdjacencyComplex & complex, const std::vector<Point> & centers)
{
  const auto tetrahedra = complex.GetTetrahedra();
  return std::count_if(tetrahedra.begin(), tetrahedra.end(), [&centers](const VertexQuadruple & t) {
    return t[0] != ExteriorVertex && Orientation(centers[t[0]], centers[t[1]], centers[t[2]], centers[t[3]]) <= 0;
  });
}

/** Carries out a move, undoes it and carries it out again, with all checks. */
void
MoveBackAndForth(AdjacencyComplex & complex, const Replacement & move)
{
  const auto        before = complex.GetTetrahedra();
  const Replacement inverse = complex.Apply(move);
  const auto        violations = FindViolations(complex);
  EXPECT_TRUE(violations.empty()) << violations[0];
  EXPECT_EQ(EulerCharacteristic(complex), 0);
  EXPECT_TRUE(complex.GetTetrahedra() != before);
  const Replacement again = complex.Apply(inverse);
  EXPECT_TRUE(complex.GetTetrahedra() == before) << "the inverse does not restore";
  complex.Apply(again);
}

constexpr int NumberOfMoves = 10000;

class RandomWalk : public testing::TestWithParam<Legality>
{};
} // namespace

TEST_P(RandomWalk, StaysValidAndEveryInverseRestores)
{
  // Walks of a few hundred moves: in a longer one all vertices become adjacent, and hardly a move is left.
  constexpr int movesOfAWalk = 200;
  Random        random(1);
  int           numbersOf[2] = { 0, 0 }; // swaps and removals
  for (int walk = 0; walk < NumberOfMoves / movesOfAWalk; ++walk)
  {
    const auto            centers = RandomCenters(12, static_cast<std::uint64_t>(walk));
    AdjacencyComplex      complex = DelaunayComplex(centers);
    const LocalOperations operations(complex, centers, GetParam());
    int                   tried = 0;
    for (int done = 0; done < movesOfAWalk;)
    {
      ASSERT_LT(++tried, 1000 * movesOfAWalk) << "walk " << walk << " is stuck after " << done << " moves";
      const Proposal move = RandomMove(complex, operations, random);
      if (move)
      {
        MoveBackAndForth(complex, move.replacement);
        ASSERT_FALSE(HasFailure()) << "walk " << walk << ", move " << done;
        ++numbersOf[move.replacement.removedEdges.empty() ? 0 : 1];
        ++done;
      }
    }
  }
  EXPECT_GT(numbersOf[0], NumberOfMoves / 10);
  EXPECT_GT(numbersOf[1], NumberOfMoves / 10);
}

INSTANTIATE_TEST_SUITE_P(Legalities, RandomWalk, testing::Values(Legality::Combinatorial, Legality::Geometric),
                         [](const testing::TestParamInfo<Legality> & info) {
                           return info.param == Legality::Geometric ? "Geometric" : "Combinatorial";
                         });

TEST(RandomWalkGeometry, GeometricLegalityKeepsEveryTetrahedronPositive)
{
  const auto centers = RandomCenters(60, 2);
  for (const Legality legality : { Legality::Geometric, Legality::Combinatorial })
  {
    AdjacencyComplex complex = DelaunayComplex(centers);
    ASSERT_EQ(NumberOfInvertedCells(complex, centers), 0);
    Random random(2);
    Scramble(complex, LocalOperations(complex, centers, legality), 2000, random);
    if (legality == Legality::Geometric)
    {
      EXPECT_EQ(NumberOfInvertedCells(complex, centers), 0);
    }
    else
    {
      EXPECT_GT(NumberOfInvertedCells(complex, centers), 0) << "combinatorial legality does not care";
    }
  }
}
