/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/TestGeneralComplexes.h"
#include "TissueTessellationCore/Common/Random.h"

#include <gtest/gtest.h>

using namespace testing_nerve;

namespace
{
/** Applies a move that must be legal. */
GeneralMove
Carry(GeneralComplex & complex, const MoveProposal & proposal)
{
  EXPECT_TRUE(proposal) << ToString(proposal.verdict);
  const auto  before = CountEdges(complex);
  GeneralMove inverse = complex.Apply(proposal.move);
  auto        expected = before;
  for (const VertexPair & edge : proposal.move.removedEdges)
  {
    --expected[edge];
  }
  for (const VertexPair & edge : proposal.move.createdEdges)
  {
    ++expected[edge];
  }
  for (auto it = expected.begin(); it != expected.end();)
  {
    it = it->second == 0 ? expected.erase(it) : std::next(it);
  }
  if (!proposal.move.removed.empty() || !proposal.move.created.empty())
  {
    EXPECT_EQ(CountEdges(complex), expected);
  }
  return inverse;
}

/** The edge between two vertices, which must be joined by one or more: the first. */
LocalEdge
EdgeOf(const GeneralComplex & complex, VertexId u, VertexId v)
{
  for (const auto & edge : complex.FindEdges())
  {
    if (edge.vertices == VertexPair{ { std::min(u, v), std::max(u, v) } })
    {
      return edge.local;
    }
  }
  throw std::invalid_argument("no such edge");
}

/** One random proposal of those that keep the links. */
MoveProposal
Propose(const GeneralComplex & complex, Random & random, bool shrink)
{
  TetrahedronId id = 0;
  do
  {
    id = static_cast<TetrahedronId>(random.Index(static_cast<std::size_t>(complex.TetrahedronIdBound())));
  } while (!complex.IsAlive(id));
  const int i = static_cast<int>(random.Index(4));
  const int j = (i + 1 + static_cast<int>(random.Index(3))) % 4;
  if (!shrink && random.Index(2) == 0)
  {
    return SwapTriangle(complex, { id, i });
  }
  const EdgeRing ring = complex.GetRing({ id, i, j });
  if (!shrink && random.Index(8) == 0)
  {
    return SplitEdge(complex, ring, random.Index(ring.size()), random.Index(ring.size()));
  }
  if (ring.size() == 2)
  {
    return CloseEdge(complex, { id, i, j });
  }
  const auto cost = [&](int, int, int) { return random.Uniform(); };
  return RemoveEdge(complex, { id, i, j }, LeastCostTriangulation(static_cast<int>(ring.size()), cost));
}
} // namespace

TEST(GeneralMoves, SwapAndRemovalAreInverse)
{
  GeneralComplex    complex = FiveCells();
  const std::string before = Dump(complex);
  EXPECT_EQ(SwapTriangle(FourCells(), { 0, 0 }).verdict, MoveVerdict::JoinsVertexToItself);
  const GeneralMove inverse = Carry(complex, SwapTriangle(complex, { 0, 0 }));
  EXPECT_EQ(complex.NumberOfTetrahedra(), 6u);
  EXPECT_TRUE(FindViolations(complex).empty());
  complex.Apply(inverse);
  EXPECT_EQ(Dump(complex), before);
}

TEST(GeneralMoves, RemovalOfAnEdgeOfAnyDegree)
{
  // A bipyramid over n cells and the two tetrahedra fans of the exterior: 1, 2 the axis, 3 ... the ring, 0 outside.
  for (int n = 3; n < 8; ++n)
  {
    std::vector<VertexQuadruple> tetrahedra;
    for (int i = 0; i < n; ++i)
    {
      const VertexId a = 3 + i;
      const VertexId b = 3 + (i + 1) % n;
      tetrahedra.push_back({ { 1, 2, a, b } });
      tetrahedra.push_back({ { 0, 1, a, b } });
      tetrahedra.push_back({ { 2, 0, a, b } });
    }
    GeneralComplex complex = Simplicial(3 + n, tetrahedra);
    ASSERT_TRUE(FindViolations(complex).empty()) << FindViolations(complex).front();
    const std::string before = Dump(complex);
    const auto        fan = LeastCostTriangulation(n, [](int i, int, int) { return i == 0 ? 0.0 : 1.0; });
    const GeneralMove inverse = Carry(complex, RemoveEdge(complex, EdgeOf(complex, 1, 2), fan));
    EXPECT_EQ(complex.NumberOfTetrahedra(), static_cast<std::size_t>(4 * n - 4));
    EXPECT_TRUE(FindViolations(complex).empty()) << FindViolations(complex).front();
    complex.Apply(inverse);
    EXPECT_EQ(Dump(complex), before);
  }
}

TEST(GeneralMoves, SplitMakesASecondWallAndCloseTakesItAway)
{
  GeneralComplex    complex = FiveCells();
  const std::string before = Dump(complex);
  const EdgeRing    ring = complex.GetRing(EdgeOf(complex, 1, 2));
  EXPECT_EQ(SplitEdge(complex, ring, 1, 1).verdict, MoveVerdict::SameTriangle);
  const GeneralMove inverse = Carry(complex, SplitEdge(complex, ring, 0, 1));
  EXPECT_EQ((CountEdges(complex)[{ { 1, 2 } }]), 2);
  EXPECT_TRUE(FindViolations(complex).empty());
  GeneralComplex closed = complex;
  for (const auto & edge : complex.FindEdges())
  {
    if (edge.degree == 2 && edge.vertices != VertexPair{ { 1, 2 } })
    {
      Carry(closed, CloseEdge(complex, edge.local));
      break;
    }
  }
  EXPECT_EQ(CountEdges(closed), CountEdges(FiveCells()));
  EXPECT_TRUE(FindViolations(closed).empty());
  complex.Apply(inverse);
  EXPECT_EQ(Dump(complex), before);
}

TEST(GeneralMoves, CloseIsRefusedWhereTheOppositeEdgesAreOne)
{
  const GeneralComplex complex = FourCells();
  EXPECT_EQ(CloseEdge(complex, { 0, 0, 1 }).verdict, MoveVerdict::SameEdge);
  EXPECT_EQ(CloseEdge(FiveCells(), { 0, 0, 1 }).verdict, MoveVerdict::WrongDegree);
}

TEST(GeneralMoves, PillowBringsInAVertex)
{
  GeneralComplex    complex = FourCells(5);
  const std::string before = Dump(complex);
  EXPECT_EQ(InsertPillow(complex, { 0, 0 }, 2).verdict, MoveVerdict::JoinsVertexToItself);
  for (int i = 0; i < 4; ++i)
  {
    const GeneralMove inverse = Carry(complex, InsertPillow(complex, { 0, i }, 4));
    EXPECT_TRUE(FindViolations(complex).empty()) << FindViolations(complex).front();
    complex.Apply(inverse);
    EXPECT_EQ(Dump(complex), before);
  }
}

TEST(GeneralMoves, ReglueTwiceIsTheIdentity)
{
  GeneralComplex complex = FourCells(6);
  complex.Apply(InsertPillow(complex, { 0, 3 }, 4).move);
  // The triangle (0, 1, 2) is there twice now: once on each side of the pillow.
  std::vector<Side> sides;
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    const int    k = 3;
    const auto & t = complex.GetTetrahedron(id).vertices;
    if (t[k] == 3)
    {
      sides.push_back({ id, k });
    }
  }
  ASSERT_EQ(sides.size(), 2u);
  const auto        links = EulerCharacteristics(complex);
  const std::string before = Dump(complex);
  EXPECT_EQ(ReglueCrosswise(complex, sides[0], complex.GetMate(sides[0])).verdict, MoveVerdict::SameTriangle);
  EXPECT_EQ(ReglueCrosswise(complex, sides[0], { 0, 0 }).verdict, MoveVerdict::DifferentVertices);
  const GeneralMove inverse = Carry(complex, ReglueCrosswise(complex, sides[0], sides[1]));
  EXPECT_EQ(EulerCharacteristics(complex)[0], (std::vector<std::int32_t>{ 2, 2 })) << "the pillow has come off";
  EXPECT_NE(EulerCharacteristics(complex), links);
  complex.Apply(inverse);
  EXPECT_EQ(Dump(complex), before);
}

TEST(GeneralMoves, ReglueJoinsPartsAgain)
{
  GeneralComplex complex(5);
  for (int part = 0; part < 2; ++part)
  {
    const TetrahedronId first = complex.Add({ { 0, 1, 2, 3 + part } });
    complex.Add({ { 1, 0, 2, 3 + part } });
    for (int i = 0; i < 4; ++i)
    {
      complex.Glue({ first, i }, { first + 1, i == 0 ? 1 : i == 1 ? 0 : i });
    }
  }
  ASSERT_FALSE(FindViolations(complex).empty());
  Carry(complex, ReglueCrosswise(complex, { 0, 3 }, { 3, 3 }));
  EXPECT_TRUE(FindViolations(complex).empty()) << FindViolations(complex).front();
}

TEST(GeneralMoves, JoinConnectsTwoParts)
{
  // Two balls of cells that have the exterior and cell 1 in common.
  GeneralComplex complex(6);
  for (int part = 0; part < 2; ++part)
  {
    const TetrahedronId first = complex.Add({ { 0, 1, 2 + 2 * part, 3 + 2 * part } });
    complex.Add({ { 1, 0, 2 + 2 * part, 3 + 2 * part } });
    for (int i = 0; i < 4; ++i)
    {
      complex.Glue({ first, i }, { first + 1, i == 0 ? 1 : i == 1 ? 0 : i });
    }
  }
  const EdgeRing first = complex.GetRing({ 0, 0, 1 });
  const EdgeRing second = complex.GetRing({ 2, 0, 1 });
  EXPECT_EQ(JoinEdges(complex, first, 0, complex.GetRing({ 2, 0, 2 }), 0).verdict, MoveVerdict::DifferentVertices);
  const GeneralMove inverse = Carry(complex, JoinEdges(complex, first, 0, second, 0));
  EXPECT_TRUE(FindViolations(complex).empty()) << FindViolations(complex).front();
  complex.Apply(inverse);
  EXPECT_EQ(EulerCharacteristics(complex)[1], (std::vector<std::int32_t>{ 2, 2 }));
}

TEST(GeneralMoves, ManyRandomMovesKeepLinksAndOrientation)
{
  GeneralComplex complex = FiveCells();
  complex.Apply(SwapTriangle(complex, { 0, 0 }).move);
  Random     random(15);
  const auto links = EulerCharacteristics(complex);
  int        legal = 0;
  for (int i = 0; i < 100000; ++i)
  {
    // Between six and some four hundred tetrahedra, up and down.
    const bool         shrink = complex.NumberOfTetrahedra() > 200 + random.Index(200);
    const MoveProposal proposal = Propose(complex, random, shrink);
    if (!proposal)
    {
      continue;
    }
    ++legal;
    const bool        isChecked = legal % 500 == 0;
    const std::string before = isChecked ? Dump(complex) : "";
    const GeneralMove inverse = complex.Apply(proposal.move);
    if (isChecked)
    {
      ASSERT_TRUE(FindViolations(complex).empty()) << i << ": " << FindViolations(complex).front();
      ASSERT_EQ(EulerCharacteristics(complex), links);
      const GeneralMove again = complex.Apply(inverse);
      ASSERT_EQ(Dump(complex), before) << i;
      complex.Apply(again);
    }
  }
  EXPECT_GT(legal, 20000);
  EXPECT_TRUE(FindViolations(complex).empty());
}

TEST(GeneralMoves, SeriesOfMovesIsUndoneByTheirInverses)
{
  GeneralComplex           complex = FiveCells();
  const std::string        before = Dump(complex);
  Random                   random(4);
  std::vector<GeneralMove> inverses;
  while (inverses.size() < 2000)
  {
    const MoveProposal proposal = Propose(complex, random, random.Index(3) == 0);
    if (proposal)
    {
      inverses.push_back(complex.Apply(proposal.move));
    }
  }
  while (!inverses.empty())
  {
    complex.Apply(inverses.back());
    inverses.pop_back();
  }
  EXPECT_EQ(Dump(complex), before);
}

TEST(GeneralMoves, TellWhetherCellsOfSeveralVerticesKeepTheirTopology)
{
  // A triangle of a tetrahedron becomes an edge between the two vertices beside it.
  const GeneralComplex five = FiveCells();
  const MoveProposal   swap = SwapTriangle(five, { 0, 0 });
  ASSERT_TRUE(swap);
  const VertexQuadruple t = five.GetTetrahedron(0).vertices;
  const VertexId        a = t[0];
  const VertexId        b = five.VertexOpposite(five.GetMate({ 0, 0 }));
  const auto            keeps = [&](const std::vector<VertexId> & vertices) {
    std::vector<VertexId> cellOf{ 0, 1, 2, 3, 4 };
    for (const VertexId v : vertices)
    {
      cellOf[v] = vertices.front();
    }
    return KeepsTopology(five, swap.move, cellOf);
  };
  EXPECT_TRUE(KeepsTopology(five, swap.move, {}));
  EXPECT_TRUE(keeps({ a }));
  EXPECT_FALSE(keeps({ a, b }));
  EXPECT_TRUE(keeps({ a, b, t[1] }));
  EXPECT_TRUE(keeps({ a, t[1] }));
  EXPECT_FALSE(keeps({ t[1], t[2], t[3] }));
  EXPECT_TRUE(keeps({ t[1], t[2], t[3], a }));
}
