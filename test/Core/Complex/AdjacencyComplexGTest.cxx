/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace tissue_test;

TEST(AdjacencyComplex, CountsTheElementsOfTheFourSimplex)
{
  const AdjacencyComplex complex(5, FourSimplex());
  EXPECT_EQ(complex.NumberOfVertices(), 5);
  EXPECT_EQ(complex.NumberOfEdges(), 10u);
  EXPECT_EQ(complex.NumberOfTetrahedra(), 5u);
  EXPECT_EQ(complex.TetrahedronIdBound(), 5);
  for (VertexId v = 0; v < 5; ++v)
  {
    EXPECT_EQ(complex.NumberOfNeighbors(v), 4);
  }
  for (const auto & edge : complex.GetEdges())
  {
    EXPECT_EQ(edge.degree, 3);
  }
}

TEST(AdjacencyComplex, NeighborsAreAcrossTheOppositeTriangle)
{
  const AdjacencyComplex complex(8, CrossPolytope());
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; i < 4; ++i)
    {
      const auto & t = complex.GetTetrahedron(id);
      const auto & other = complex.GetTetrahedron(t.neighbors[i]);
      const int    mirror = complex.MirrorIndex(id, i);
      // Across a triangle of the cross-polytope is the vertex opposite to the one that is left.
      EXPECT_EQ(other.vertices[mirror], (t.vertices[i] + 4) % 8);
      EXPECT_EQ(other.neighbors[mirror], id);
    }
  }
}

TEST(AdjacencyComplex, RefusesWhatIsNotClosed)
{
  auto tetrahedra = FourSimplex();
  tetrahedra.pop_back();
  EXPECT_THROW(AdjacencyComplex(5, tetrahedra), std::invalid_argument);
}

TEST(AdjacencyComplex, RefusesATriangleInFourTetrahedra)
{
  // Two 4-simplices on the triangle (1, 2, 3).
  auto       tetrahedra = FourSimplex();
  const auto first = tetrahedra;
  for (VertexQuadruple t : first)
  {
    for (VertexId & v : t)
    {
      v = v == 0 ? 5 : v == 4 ? 6 : v;
    }
    tetrahedra.push_back(t);
  }
  EXPECT_THROW(AdjacencyComplex(7, tetrahedra), std::invalid_argument);
}

TEST(AdjacencyComplex, RefusesAnInvertedTetrahedron)
{
  auto tetrahedra = FourSimplex();
  std::swap(tetrahedra[2][0], tetrahedra[2][1]);
  EXPECT_THROW(AdjacencyComplex(5, tetrahedra), std::invalid_argument);
}

TEST(AdjacencyComplex, NamesAVertexOutOfRange)
{
  try
  {
    AdjacencyComplex(4, FourSimplex());
    FAIL() << "vertex 4 was taken";
  }
  catch (const std::invalid_argument & error)
  {
    EXPECT_NE(std::string(error.what()).find("vertex 4"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("0 .. 3"), std::string::npos) << error.what();
  }
}

TEST(AdjacencyComplex, RingIsTheLinkOfTheEdgeInPositiveOrder)
{
  const AdjacencyComplex complex(8, Bipyramid(5));
  for (const VertexPair edge : { VertexPair{ { 1, 2 } }, VertexPair{ { 2, 1 } } })
  {
    auto ring = complex.GetRing(edge[0], edge[1]);
    ASSERT_EQ(ring.vertices.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i)
    {
      const VertexQuadruple expected{ { edge[0], edge[1], ring.vertices[i], ring.vertices[(i + 1) % 5] } };
      EXPECT_EQ(Canonical(complex.GetTetrahedron(ring.tetrahedra[i]).vertices), Canonical(expected));
    }
    std::rotate(
      ring.vertices.begin(), std::min_element(ring.vertices.begin(), ring.vertices.end()), ring.vertices.end());
    const std::vector<VertexId> ascending{ 3, 4, 5, 6, 7 };
    const std::vector<VertexId> reversed{ 3, 7, 6, 5, 4 };
    EXPECT_EQ(std::vector<VertexId>(ring.vertices.begin(), ring.vertices.end()), edge[0] == 1 ? ascending : reversed);
  }
}

TEST(AdjacencyComplex, RingOfVerticesThatAreNotAdjacentThrows)
{
  const AdjacencyComplex complex(8, CrossPolytope());
  EXPECT_THROW(complex.GetRing(1, 5), std::invalid_argument);
}

TEST(AdjacencyComplex, FindsEdgesAndTrianglesOfEveryOrder)
{
  const AdjacencyComplex complex(7, Bipyramid(4));
  ASSERT_NE(complex.FindEdge(2, 1), nullptr);
  EXPECT_EQ(complex.FindEdge(2, 1)->degree, 4);
  EXPECT_EQ(complex.FindEdge(2, 1)->vertices, (VertexPair{ { 1, 2 } }));
  EXPECT_EQ(complex.FindEdge(3, 5), nullptr) << "a diagonal of the ring";
  EXPECT_TRUE(complex.HasTriangle(4, 2, 1));
  EXPECT_TRUE(complex.HasTriangle(3, 0, 4));
  EXPECT_FALSE(complex.HasTriangle(3, 4, 5)) << "3 and 5 are not adjacent";
  EXPECT_FALSE(complex.HasTriangle(0, 1, 2)) << "three edges, but no triangle";
}

TEST(AdjacencyComplex, TetrahedraAndEdgesDoNotDependOnTheOrderOfTheInput)
{
  auto                   tetrahedra = Bipyramid(6);
  const AdjacencyComplex complex(9, tetrahedra);
  std::reverse(tetrahedra.begin(), tetrahedra.end());
  for (VertexQuadruple & t : tetrahedra)
  {
    std::rotate(t.begin(), t.begin() + 1, t.begin() + 3); // an even permutation
  }
  const AdjacencyComplex same(9, tetrahedra);
  EXPECT_EQ(complex.GetTetrahedra(), same.GetTetrahedra());
  const auto ranks = same.GetTetrahedronRanks();
  for (TetrahedronId id = 0; id < same.TetrahedronIdBound(); ++id)
  {
    EXPECT_EQ(complex.GetTetrahedra()[ranks[id]], Canonical(same.GetTetrahedron(id).vertices));
  }
}

TEST(AdjacencyComplex, CanonicalKeepsTheOrientation)
{
  EXPECT_EQ(Canonical({ { 4, 7, 2, 9 } }), Canonical({ { 7, 2, 4, 9 } })) << "a cycle of three is even";
  EXPECT_NE(Canonical({ { 4, 7, 2, 9 } }), Canonical({ { 7, 4, 2, 9 } })) << "a transposition is odd";
  EXPECT_EQ(Canonical({ { 4, 7, 2, 9 } }), (VertexQuadruple{ { 2, 4, 7, 9 } }));
}

namespace
{
/** The swap of the triangle (1, 2, 3) of the bipyramid on the ring of three, written by hand: 3 to 2 tetrahedra. */
Replacement
RemovalByHand(const AdjacencyComplex & complex)
{
  Replacement replacement;
  const auto  ring = complex.GetRing(1, 2);
  replacement.removed.assign(ring.tetrahedra.begin(), ring.tetrahedra.end());
  replacement.created = { { { 2, 3, 5, 4 } }, { { 1, 3, 4, 5 } } };
  replacement.removedEdges = { { { 1, 2 } } };
  return replacement;
}
} // namespace

TEST(AdjacencyComplex, ApplyReplacesAndItsInverseRestores)
{
  AdjacencyComplex  complex(6, Bipyramid(3));
  const auto        before = complex.GetTetrahedra();
  const Replacement inverse = complex.Apply(RemovalByHand(complex));
  EXPECT_EQ(complex.NumberOfTetrahedra(), 8u);
  EXPECT_EQ(complex.FindEdge(1, 2), nullptr);
  EXPECT_TRUE(complex.HasTriangle(3, 4, 5));
  EXPECT_EQ(complex.NumberOfNeighbors(1), 4);
  EXPECT_TRUE(FindViolations(complex).empty());
  const auto ranks = complex.GetTetrahedronRanks();
  EXPECT_EQ(std::count(ranks.begin(), ranks.end(), -1), 1) << "one id is free";

  complex.Apply(inverse);
  EXPECT_EQ(complex.GetTetrahedra(), before);
  EXPECT_EQ(complex.TetrahedronIdBound(), 9) << "the ids were taken again";
  EXPECT_TRUE(FindViolations(complex).empty());
}

TEST(AdjacencyComplex, ApplyMisusedThrowsAndChangesNothing)
{
  AdjacencyComplex  complex(6, Bipyramid(3));
  const Replacement good = RemovalByHand(complex);
  const auto        before = complex.GetTetrahedra();
  const auto        expectRefusal = [&](const Replacement & replacement, const char * what) {
    EXPECT_THROW(complex.Apply(replacement), std::logic_error) << what;
    EXPECT_EQ(complex.GetTetrahedra(), before) << what;
    EXPECT_TRUE(FindViolations(complex).empty()) << what;
  };
  Replacement bad = good;
  bad.removed.pop_back();
  expectRefusal(bad, "too few removed");
  bad = good;
  bad.created.pop_back();
  expectRefusal(bad, "too few created");
  bad = good;
  bad.removed.push_back(bad.removed[0]);
  expectRefusal(bad, "one removed twice");
  bad = good;
  for (VertexQuadruple & t : bad.created)
  {
    std::swap(t[0], t[1]);
  }
  expectRefusal(bad, "created ones inverted");
  bad = good;
  bad.removed[0] = complex.TetrahedronIdBound();
  expectRefusal(bad, "no such tetrahedron");
}

TEST(AdjacencyComplex, ApplyRefusesAReplacementThatWasAppliedAlready)
{
  AdjacencyComplex  complex(6, Bipyramid(3));
  const Replacement replacement = RemovalByHand(complex);
  complex.Apply(replacement);
  const auto after = complex.GetTetrahedra();
  EXPECT_THROW(complex.Apply(replacement), std::logic_error);
  EXPECT_EQ(complex.GetTetrahedra(), after);
}
