/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/TestGeneralComplexes.h"

#include <gtest/gtest.h>

using namespace testing_nerve;

TEST(GeneralComplex, SmallestSpheresAreValid)
{
  EXPECT_TRUE(FindViolations(FiveCells()).empty()) << FindViolations(FiveCells()).front();
  EXPECT_TRUE(FindViolations(FourCells()).empty()) << FindViolations(FourCells()).front();
}

TEST(GeneralComplex, RingIsPositivelyOrientedAndClosed)
{
  const GeneralComplex complex = FiveCells();
  for (const auto & edge : complex.FindEdges())
  {
    EXPECT_EQ(edge.degree, 3);
    const EdgeRing ring = complex.GetRing(edge.local);
    const auto     vertices = complex.GetRingVertices(ring);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const RingStep & s = ring[i];
      const auto &     t = complex.GetTetrahedron(s.tetrahedron).vertices;
      EXPECT_TRUE(IsEven({ { s.from, s.to, s.here, s.next } }));
      EXPECT_EQ(t[s.from], edge.vertices[0]);
      EXPECT_EQ(t[s.to], edge.vertices[1]);
      EXPECT_EQ(t[s.next], vertices[(i + 1) % ring.size()]);
    }
  }
}

TEST(GeneralComplex, TwoTetrahedraThatShareAllTrianglesHaveSixEdgesOfDegreeTwo)
{
  const auto edges = FourCells().FindEdges();
  ASSERT_EQ(edges.size(), 6u);
  for (const auto & edge : edges)
  {
    EXPECT_EQ(edge.degree, 2);
  }
}

TEST(GeneralComplex, RefusesTetrahedraAndGluingsThatAreNone)
{
  GeneralComplex complex(5);
  EXPECT_THROW(complex.Add({ { 0, 1, 2, 2 } }), std::invalid_argument);
  EXPECT_THROW(complex.Add({ { 0, 1, 2, 5 } }), std::invalid_argument);
  complex.Add({ { 0, 1, 2, 3 } });
  complex.Add({ { 0, 1, 2, 4 } });
  EXPECT_THROW(complex.Glue({ 0, 3 }, { 1, 3 }), std::invalid_argument) << "oriented alike";
  EXPECT_THROW(complex.Glue({ 0, 0 }, { 1, 3 }), std::invalid_argument) << "other vertices";
}

TEST(GeneralComplex, MisfitMovesThrowAndChangeNothing)
{
  GeneralComplex    complex = FiveCells();
  const std::string before = Dump(complex);
  GeneralMove       move;
  move.removed = { 7 };
  EXPECT_THROW(complex.Apply(move), std::logic_error);
  move.removed.clear();
  move.gluings.push_back({ { 0, 0 }, { 0, 1 } });
  EXPECT_THROW(complex.Apply(move), std::logic_error);
  move.gluings[0] = { { GeneralMove::Created(0), 0 }, { 0, 1 } };
  EXPECT_THROW(complex.Apply(move), std::logic_error);
  EXPECT_EQ(Dump(complex), before);
}

TEST(GeneralValidity, NamesTrianglesThatAreOpen)
{
  GeneralComplex complex(4);
  complex.Add({ { 0, 1, 2, 3 } });
  const auto violations = FindViolations(complex);
  ASSERT_EQ(violations.size(), 4u);
  EXPECT_EQ(violations[0], "tetrahedron (0, 1, 2, 3) has no neighbour 0");
}

TEST(GeneralValidity, NamesAbsentAndSplitVertices)
{
  GeneralComplex complex(6);
  for (int part = 0; part < 2; ++part)
  {
    const TetrahedronId first = complex.Add({ { 0, 1, 2, 3 + part } });
    complex.Add({ { 1, 0, 2, 3 + part } });
    for (int i = 0; i < 4; ++i)
    {
      complex.Glue({ first, i }, { first + 1, i == 0 ? 1 : i == 1 ? 0 : i });
    }
  }
  const auto                     violations = FindViolations(complex);
  const std::vector<std::string> expected{ "the link of vertex 1 is split into 2 surfaces",
                                           "the link of vertex 2 is split into 2 surfaces",
                                           "vertex 5 is in no tetrahedron" };
  EXPECT_EQ(violations, expected) << "the exterior may have several links";
}

TEST(GeneralValidity, NamesLinksWithHandles)
{
  // Two edges (0, 3) of one link, joined: the links of both ends get a handle.
  GeneralComplex complex = FourCells();
  const EdgeRing ring = complex.GetRing({ 0, 0, 3 });
  complex.Apply(SplitEdge(complex, ring, 0, 1).move);
  std::vector<LocalEdge> edges;
  for (const auto & edge : complex.FindEdges())
  {
    if (edge.vertices == VertexPair{ { 0, 3 } })
    {
      edges.push_back(edge.local);
    }
  }
  ASSERT_EQ(edges.size(), 2u);
  const EdgeRing    first = complex.GetRing(edges[0]);
  const EdgeRing    second = complex.GetRing(edges[1]);
  const auto        firsts = complex.GetRingVertices(first);
  const auto        seconds = complex.GetRingVertices(second);
  const std::size_t j = seconds[0] != firsts[0] ? 0 : 1;
  complex.Apply(JoinEdges(complex, first, 0, second, j).move);
  const auto violations = FindViolations(complex);
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0], "the link of vertex 3 is no sphere: its Euler characteristic is 0");
  EXPECT_EQ(EulerCharacteristics(complex)[0], std::vector<std::int32_t>{ 0 }) << "which the exterior may have";
}
