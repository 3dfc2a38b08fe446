/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/LocalOperations.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

using namespace tissue_test;

namespace
{
const VertexPair Axis{ { 1, 2 } };

const auto NoCost = [](const AdjacencyComplex::Ring &, int, int, int) { return 0.0; };

/** A convex ring of n cells around the axis, no four of them on a circle. */
std::vector<Point>
Ring(int n)
{
  std::vector<Point> ring;
  for (int i = 0; i < n; ++i)
  {
    const double angle = 6.283185307179586 * (i + 0.1) / n;
    ring.push_back({ { 2.0 * std::cos(angle), std::sin(angle), 0.1 * i } });
  }
  return ring;
}

/** Rings of four: wide in x, so the diagonal (4, 6) is the shorter one; wide in y, so (3, 5) is. */
const std::vector<Point> WideInX{ { { 2, 0, 0 } }, { { 0, 1, 0 } }, { { -2, 0, 0 } }, { { 0, -1, 0 } } };
const std::vector<Point> WideInY{ { { 1, 0, 0 } }, { { 0, 2, 0 } }, { { -1, 0, 0 } }, { { 0, -2, 0 } } };

std::pair<Verdict, Verdict>
Verdicts(const AdjacencyComplex & complex, const std::vector<Point> & centers, VertexPair edge)
{
  return { LocalOperations(complex, centers, Legality::Combinatorial).RemoveEdge(edge).verdict,
           LocalOperations(complex, centers, Legality::Geometric).RemoveEdge(edge).verdict };
}

std::pair<Verdict, Verdict>
Both(Verdict verdict)
{
  return { verdict, verdict };
}

const std::pair<Verdict, Verdict> GeometricallyInverted{ Verdict::Legal, Verdict::Inverted };
} // namespace

TEST(EdgeRemoval, OfEveryDegreeMakesTwoNMinusFourTetrahedra)
{
  for (int n = 3; n <= 7; ++n)
  {
    AdjacencyComplex      complex(n + 3, Bipyramid(n));
    const auto            centers = BipyramidCenters(Ring(n));
    const LocalOperations operations(complex, centers, Legality::Geometric);
    const auto            before = complex.GetTetrahedra();
    const Proposal        proposal = operations.RemoveEdge(Axis);
    ASSERT_TRUE(proposal) << n << ": " << ToString(proposal.verdict);
    EXPECT_EQ(proposal.replacement.removed.size(), static_cast<std::size_t>(n));
    EXPECT_EQ(proposal.replacement.created.size(), static_cast<std::size_t>(2 * n - 4));
    EXPECT_EQ(proposal.replacement.createdEdges.size(), static_cast<std::size_t>(n - 3));
    EXPECT_EQ(complex.GetTetrahedra(), before) << "a proposal changes nothing";

    const std::size_t edges = complex.NumberOfEdges();
    const Replacement inverse = complex.Apply(proposal.replacement);
    EXPECT_EQ(complex.FindEdge(1, 2), nullptr);
    EXPECT_EQ(complex.NumberOfEdges(), edges - 1 + static_cast<std::size_t>(n - 3));
    EXPECT_TRUE(FindViolations(complex).empty()) << n;
    complex.Apply(inverse);
    EXPECT_EQ(complex.GetTetrahedra(), before);
  }
}

TEST(EdgeRemoval, TriangulatesByTheDelaunayOfTheProjection)
{
  const AdjacencyComplex complex(7, Bipyramid(4));
  for (const auto & [ring, diagonal] :
       { std::make_pair(WideInX, VertexPair{ { 4, 6 } }), std::make_pair(WideInY, VertexPair{ { 3, 5 } }) })
  {
    const auto     centers = BipyramidCenters(ring);
    const Proposal proposal = LocalOperations(complex, centers, Legality::Geometric).RemoveEdge(Axis);
    ASSERT_TRUE(proposal);
    ASSERT_EQ(proposal.replacement.createdEdges.size(), 1u);
    EXPECT_EQ(proposal.replacement.createdEdges[0], diagonal);
  }
}

TEST(EdgeRemoval, TakesTheTriangulationOfLeastCost)
{
  const AdjacencyComplex complex(9, Bipyramid(6));
  const auto             centers = BipyramidCenters(Ring(6));
  const auto             awayFromSix = [](const AdjacencyComplex::Ring & ring, int i, int j, int k) {
    EXPECT_LT(i, j);
    EXPECT_LT(j, k);
    return ring.vertices[i] == 6 || ring.vertices[j] == 6 || ring.vertices[k] == 6 ? 0.0 : 1.0;
  };
  const Proposal proposal = LocalOperations(complex, centers, Legality::Geometric).RemoveEdge(Axis, awayFromSix);
  ASSERT_TRUE(proposal);
  // No cost at all: the fan of all four triangles at vertex 6.
  for (const VertexPair & diagonal : proposal.replacement.createdEdges)
  {
    EXPECT_TRUE(diagonal[0] == 6 || diagonal[1] == 6) << diagonal[0] << " " << diagonal[1];
  }
}

TEST(EdgeRemoval, RefusedAboveTheDegreeLimit)
{
  const AdjacencyComplex complex(8, Bipyramid(5));
  const auto             centers = BipyramidCenters(Ring(5));
  LocalOperations        operations(complex, centers, Legality::Geometric);
  operations.SetMaximumDegree(5);
  EXPECT_TRUE(operations.RemoveEdge(Axis));
  operations.SetMaximumDegree(4);
  EXPECT_EQ(operations.RemoveEdge(Axis).verdict, Verdict::DegreeAboveLimit);
  EXPECT_EQ(operations.RemoveEdge(Axis, NoCost).verdict, Verdict::DegreeAboveLimit);
}

TEST(EdgeRemoval, RefusedWhereTheProjectedRingCrossesItself)
{
  const AdjacencyComplex complex(7, Bipyramid(4));
  auto                   ring = WideInX;
  std::swap(ring[1], ring[2]);
  const auto centers = BipyramidCenters(ring);
  EXPECT_EQ(Verdicts(complex, centers, Axis), Both(Verdict::NoTriangulation));
}

TEST(EdgeRemoval, RefusedWhereTheDiagonalExists)
{
  AdjacencyComplex complex(7, Bipyramid(4));
  const auto       centers = BipyramidCenters(WideInY);
  // Outside of the bipyramid, 3 and 5 are made neighbours over the surface edge (2, 4).
  const auto    ring = complex.GetRing(2, 4);
  TetrahedronId outside = -1;
  for (const TetrahedronId id : ring.tetrahedra)
  {
    const auto & t = complex.GetTetrahedron(id).vertices;
    outside = std::count(t.begin(), t.end(), 3) + std::count(t.begin(), t.end(), ExteriorVertex) == 2 ? id : outside;
  }
  const LocalOperations operations(complex, centers, Legality::Combinatorial);
  const auto &          t = complex.GetTetrahedron(outside).vertices;
  complex.Apply(
    operations.SwapTriangle(outside, static_cast<int>(std::find(t.begin(), t.end(), 3) - t.begin())).replacement);
  ASSERT_NE(complex.FindEdge(3, 5), nullptr);
  ASSERT_EQ(complex.FindEdge(1, 2)->degree, 4);

  EXPECT_EQ(Verdicts(complex, centers, Axis), Both(Verdict::EdgeExists));
  const Proposal other = operations.RemoveEdge(Axis, NoCost);
  ASSERT_TRUE(other) << "the other diagonal is free";
  EXPECT_EQ(other.replacement.createdEdges[0], (VertexPair{ { 4, 6 } }));
}

TEST(EdgeRemoval, RefusedWhereNoTriangulationIsAllowed)
{
  // Every diagonal exists in a cyclic polytope.
  const AdjacencyComplex neighborly(7, CyclicPolytope(7));
  const auto             centers = RandomCenters(6, 1);
  const LocalOperations  operations(neighborly, centers, Legality::Combinatorial);
  int                    tried = 0;
  for (const auto & edge : neighborly.GetEdges())
  {
    if (edge.degree > 3)
    {
      EXPECT_EQ(operations.RemoveEdge(edge.vertices, NoCost).verdict, Verdict::NoTriangulation);
      ++tried;
    }
  }
  EXPECT_GT(tried, 0);

  const AdjacencyComplex bipyramid(7, Bipyramid(4));
  const auto             forbidden = [](const AdjacencyComplex::Ring &, int, int, int) {
    return std::numeric_limits<double>::infinity();
  };
  EXPECT_EQ(LocalOperations(bipyramid, centers, Legality::Combinatorial).RemoveEdge(Axis, forbidden).verdict,
            Verdict::NoTriangulation);
}

TEST(EdgeRemoval, RefusedWhereTheTriangleExists)
{
  const AdjacencyComplex complex(5, FourSimplex());
  const auto             centers = RegularTetrahedron();
  EXPECT_EQ(Verdicts(complex, centers, Axis), Both(Verdict::TriangleExists));
  EXPECT_EQ(LocalOperations(complex, centers, Legality::Combinatorial).RemoveEdge(Axis, NoCost).verdict,
            Verdict::TriangleExists);
}

TEST(EdgeRemoval, RefusedGeometricallyWhereTheRingPassesBeyondAnEnd)
{
  const AdjacencyComplex complex(7, Bipyramid(4));
  auto                   ring = WideInY;
  ring[0][2] = ring[2][2] = 3.0; // the new edge (3, 5) at height 3, the upper end of the axis at 1
  EXPECT_EQ(Verdicts(complex, BipyramidCenters(ring), Axis), GeometricallyInverted);
}

TEST(EdgeRemoval, ExteriorInTheRingFlipsTheSurfaceEdge)
{
  AdjacencyComplex complex(7, Bipyramid(4));
  const auto centers = BipyramidCenters({ { { 1, 0.3, 0 } }, { { 0, 1, 0 } }, { { -1, 0.3, 0 } }, { { 0, -1, 0 } } });
  const Proposal proposal = LocalOperations(complex, centers, Legality::Geometric).RemoveEdge({ { 2, 4 } });
  ASSERT_TRUE(proposal) << ToString(proposal.verdict);
  complex.Apply(proposal.replacement);
  EXPECT_TRUE(complex.HasTriangle(ExteriorVertex, 3, 5));
  EXPECT_FALSE(complex.HasTriangle(ExteriorVertex, 2, 4));
  EXPECT_TRUE(FindViolations(complex).empty());
}

TEST(EdgeRemoval, ExteriorAsAnEndCoversAPitAndNotATip)
{
  // Vertex 3 is covered by the new edge (4, 6): legal where it lies below, not where it sticks out.
  const AdjacencyComplex complex(7, Bipyramid(4));
  const auto tip = BipyramidCenters({ { { 1, 0, 0 } }, { { 0, 0.5, 0 } }, { { -1, 0, 0 } }, { { 0, -0.5, 0 } } });
  EXPECT_EQ(Verdicts(complex, tip, { { ExteriorVertex, 3 } }), GeometricallyInverted);
  const auto pit = BipyramidCenters({ { { 0.2, 0, 0 } }, { { 0.6, 1, 0 } }, { { -1, 0, 0 } }, { { 0.6, -1, 0 } } });
  EXPECT_EQ(Verdicts(complex, pit, { { ExteriorVertex, 3 } }).second, Verdict::Legal);
}

TEST(EdgeRemoval, OfVerticesThatAreNotAdjacentThrows)
{
  const AdjacencyComplex complex(7, Bipyramid(4));
  const auto             centers = BipyramidCenters(WideInX);
  const LocalOperations  operations(complex, centers, Legality::Combinatorial);
  EXPECT_THROW(operations.RemoveEdge({ { 3, 5 } }), std::invalid_argument);
  EXPECT_THROW(operations.RemoveEdge({ { 3, 5 } }, NoCost), std::invalid_argument);
}
