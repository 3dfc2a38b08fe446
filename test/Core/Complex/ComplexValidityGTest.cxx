/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <string>

using namespace tissue_test;

namespace
{
/** The tetrahedra with vertex v at map[v]. */
std::vector<VertexQuadruple>
Relabelled(std::vector<VertexQuadruple> tetrahedra, const std::vector<VertexId> & map)
{
  for (VertexQuadruple & t : tetrahedra)
  {
    for (VertexId & v : t)
    {
      v = map[v];
    }
  }
  return tetrahedra;
}

std::vector<std::string>
ViolationsOf(VertexId numberOfVertices, const std::vector<VertexQuadruple> & tetrahedra)
{
  return FindViolations(AdjacencyComplex(numberOfVertices, tetrahedra));
}

std::vector<std::string>
ViolationsOfUnion(VertexId numberOfVertices, std::vector<VertexQuadruple> first,
                  const std::vector<VertexQuadruple> & second)
{
  first.insert(first.end(), second.begin(), second.end());
  return ViolationsOf(numberOfVertices, first);
}

testing::AssertionResult
AreExactly(const std::vector<std::string> & violations, std::size_t number, const std::string & text)
{
  for (const std::string & violation : violations)
  {
    if (violation.find(text) == std::string::npos)
    {
      return testing::AssertionFailure() << "unexpected: " << violation;
    }
  }
  if (violations.size() != number)
  {
    return testing::AssertionFailure() << violations.size() << " violations instead of " << number;
  }
  return testing::AssertionSuccess();
}
} // namespace

TEST(ComplexValidity, NothingIsWrongWithValidComplexes)
{
  EXPECT_TRUE(AreExactly(ViolationsOf(5, FourSimplex()), 0, ""));
  EXPECT_TRUE(AreExactly(ViolationsOf(8, CrossPolytope()), 0, ""));
  EXPECT_TRUE(AreExactly(ViolationsOf(8, CyclicPolytope(8)), 0, ""));
  for (int n = 3; n < 8; ++n)
  {
    EXPECT_TRUE(AreExactly(ViolationsOf(n + 3, Bipyramid(n)), 0, ""));
  }
}

TEST(ComplexValidity, FindsAVertexThatIsNotThere)
{
  EXPECT_TRUE(AreExactly(ViolationsOf(7, FourSimplex()), 2, "is in no tetrahedron"));
}

TEST(ComplexValidity, FindsATetrahedronThatExistsTwice)
{
  // Two tetrahedra, inside and outside of the same four triangles: closed, but not simplicial.
  EXPECT_TRUE(AreExactly(ViolationsOf(4, { { { 0, 1, 2, 3 } }, { { 1, 0, 2, 3 } } }), 1, "exists twice"));
}

TEST(ComplexValidity, FindsTwoPieces)
{
  const auto other = Relabelled(FourSimplex(), { 5, 6, 7, 8, 9 });
  EXPECT_TRUE(AreExactly(ViolationsOfUnion(10, FourSimplex(), other), 1, "not one piece: it has 2"));
}

TEST(ComplexValidity, FindsTwoSpheresGluedAtAVertex)
{
  // The link of vertex 0 is two spheres.
  const auto other = Relabelled(FourSimplex(), { 0, 5, 6, 7, 8 });
  EXPECT_TRUE(AreExactly(
    ViolationsOfUnion(9, FourSimplex(), other), 1, "link of vertex 0 is not one sphere: Euler characteristic 4"));
}

TEST(ComplexValidity, FindsTwoSpheresGluedAtTwoVertices)
{
  // Vertices 1 and 5 of the cross-polytope are not adjacent, so the two share no edge.
  const auto other = Relabelled(CrossPolytope(), { 8, 1, 9, 10, 11, 5, 12, 13 });
  EXPECT_TRUE(AreExactly(ViolationsOfUnion(14, CrossPolytope(), other), 2, "is not one sphere"));
}

TEST(ComplexValidity, FindsTwoSpheresGluedAtAnEdge)
{
  // The links of vertices 0 and 1 are two spheres that share a vertex: V - E + F = 7 - 12 + 8.
  const auto other = Relabelled(FourSimplex(), { 0, 1, 5, 6, 7 });
  EXPECT_TRUE(AreExactly(ViolationsOfUnion(8, FourSimplex(), other), 2, "Euler characteristic 3"));
}

TEST(ComplexValidity, FindsTwoSpheresGluedAtACycleOfEdges)
{
  // Along the cycle 0, 1, 4, 5 each link is two spheres that share two vertices, which have the Euler characteristic of
  // one: only the walk around the four edges tells.
  const auto other = Relabelled(CrossPolytope(), { 0, 1, 8, 9, 4, 5, 10, 11 });
  EXPECT_TRUE(AreExactly(ViolationsOfUnion(12, CrossPolytope(), other), 4, "are not one cycle"));
}

TEST(ComplexValidity, FindsLinksThatAreTori)
{
  // The suspension of Moebius' torus of seven vertices, with the apexes 7 and 8.
  std::vector<VertexQuadruple> tetrahedra;
  for (VertexId apex = 7; apex <= 8; ++apex)
  {
    for (int i = 0; i < 7; ++i)
    {
      tetrahedra.push_back({ { i, (i + 1) % 7, (i + 3) % 7, apex } });
      tetrahedra.push_back({ { i, (i + 2) % 7, (i + 3) % 7, apex } });
    }
  }
  EXPECT_TRUE(AreExactly(ViolationsOf(9, Oriented(tetrahedra)), 2, "Euler characteristic 0"));
}
