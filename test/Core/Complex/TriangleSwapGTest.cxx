/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/LocalOperations.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <utility>

using namespace tissue_test;

namespace
{
/** Two tetrahedra on the triangle (3, 4, 5), with the vertices 1 below and 2 above it: what Bipyramid(3) becomes where
 * its axis is removed. */
std::vector<VertexQuadruple>
TwoTetrahedra()
{
  std::vector<VertexQuadruple> tetrahedra{ { { 1, 3, 4, 5 } }, { { 2, 3, 5, 4 } } };
  for (const VertexQuadruple & t : Bipyramid(3))
  {
    if (t[0] == ExteriorVertex)
    {
      tetrahedra.push_back(t);
    }
  }
  return tetrahedra;
}

std::vector<Point>
TwoTetrahedraCenters()
{
  return BipyramidCenters({ { { 2, 0, 0 } }, { { -1, 1, 0 } }, { { -1, -1, 0 } } });
}

/** The tetrahedron of cells 1 to 4, divided by the cell 5 inside. */
std::vector<VertexQuadruple>
DividedTetrahedron()
{
  std::vector<VertexQuadruple> tetrahedra;
  for (int i = 0; i < 4; ++i)
  {
    const VertexTriple t = TriangleOpposite({ { 1, 2, 3, 4 } }, i);
    tetrahedra.push_back({ { 5, t[0], t[1], t[2] } });
    tetrahedra.push_back(ToExterior(t[0], t[1], t[2]));
  }
  return tetrahedra;
}

/** Proposes to swap the triangle (a, b, c). */
Proposal
Swap(const AdjacencyComplex & complex, const std::vector<Point> & centers, Legality legality, VertexTriple triangle)
{
  std::sort(triangle.begin(), triangle.end());
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; i < 4; ++i)
    {
      VertexTriple other = TriangleOpposite(complex.GetTetrahedron(id).vertices, i);
      std::sort(other.begin(), other.end());
      if (other == triangle)
      {
        return LocalOperations(complex, centers, legality).SwapTriangle(id, i);
      }
    }
  }
  ADD_FAILURE() << "no such triangle";
  return {};
}

/** The verdicts by combinatorial and by geometric legality. */
std::pair<Verdict, Verdict>
Verdicts(const std::vector<VertexQuadruple> & tetrahedra, const std::vector<Point> & centers, VertexTriple triangle)
{
  const AdjacencyComplex complex(static_cast<VertexId>(centers.size()), tetrahedra);
  return { Swap(complex, centers, Legality::Combinatorial, triangle).verdict,
           Swap(complex, centers, Legality::Geometric, triangle).verdict };
}

const std::pair<Verdict, Verdict> BothLegal{ Verdict::Legal, Verdict::Legal };
const std::pair<Verdict, Verdict> GeometricallyInverted{ Verdict::Legal, Verdict::Inverted };
} // namespace

TEST(TriangleSwap, OfAConvexPairIsTheEdgeBetweenTheApexes)
{
  const auto       centers = TwoTetrahedraCenters();
  AdjacencyComplex complex(6, TwoTetrahedra());
  const Proposal   proposal = Swap(complex, centers, Legality::Geometric, { { 3, 4, 5 } });
  ASSERT_TRUE(proposal) << ToString(proposal.verdict);
  EXPECT_EQ(proposal.replacement.removed.size(), 2u);
  EXPECT_EQ(proposal.replacement.created.size(), 3u);
  EXPECT_TRUE(proposal.replacement.removedEdges.empty());
  ASSERT_EQ(proposal.replacement.createdEdges.size(), 1u);
  EXPECT_EQ(proposal.replacement.createdEdges[0], (VertexPair{ { 1, 2 } }));
  complex.Apply(proposal.replacement);
  EXPECT_EQ(complex.GetTetrahedra(), AdjacencyComplex(6, Bipyramid(3)).GetTetrahedra());
}

TEST(TriangleSwap, ProposalChangesNothing)
{
  const AdjacencyComplex complex(6, TwoTetrahedra());
  const auto             before = complex.GetTetrahedra();
  Swap(complex, TwoTetrahedraCenters(), Legality::Geometric, { { 3, 4, 5 } });
  EXPECT_EQ(complex.GetTetrahedra(), before);
}

TEST(TriangleSwap, OfANonConvexPairIsGeometricallyInverted)
{
  auto centers = TwoTetrahedraCenters();
  centers[2] = { { 5, 0, 1 } }; // the new edge meets the plane of the triangle at (2.5, 0, 0), beyond its corner
  EXPECT_EQ(Verdicts(TwoTetrahedra(), centers, { { 3, 4, 5 } }), GeometricallyInverted);
}

TEST(TriangleSwap, ThroughACornerIsGeometricallyFlat)
{
  auto centers = TwoTetrahedraCenters();
  centers[2] = { { 4, 0, 1 } }; // the new edge meets the corner (2, 0, 0)
  EXPECT_EQ(Verdicts(TwoTetrahedra(), centers, { { 3, 4, 5 } }), GeometricallyInverted);
}

TEST(TriangleSwap, RefusedWhereTheEdgeExists)
{
  // Every two vertices are adjacent in a cyclic polytope.
  const AdjacencyComplex complex(7, CyclicPolytope(7));
  const auto             centers = RandomCenters(6, 1);
  const LocalOperations  operations(complex, centers, Legality::Combinatorial);
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; i < 4; ++i)
    {
      const Proposal proposal = operations.SwapTriangle(id, i);
      EXPECT_EQ(proposal.verdict, Verdict::EdgeExists);
      EXPECT_FALSE(proposal);
    }
  }
}

TEST(TriangleSwap, ExteriorAsAnApexExposesTheCellBehind)
{
  auto centers = RegularTetrahedron();
  centers.push_back({ { 0.1, 0.05, 0 } });
  EXPECT_EQ(Verdicts(DividedTetrahedron(), centers, { { 1, 2, 3 } }), BothLegal);

  AdjacencyComplex complex(6, DividedTetrahedron());
  EXPECT_EQ(complex.FindEdge(ExteriorVertex, 5), nullptr);
  complex.Apply(Swap(complex, centers, Legality::Geometric, { { 1, 2, 3 } }).replacement);
  EXPECT_NE(complex.FindEdge(ExteriorVertex, 5), nullptr);
  EXPECT_TRUE(FindViolations(complex).empty());
}

TEST(TriangleSwap, ExteriorAsAnApexMustSeeTheCellBehindThroughTheTriangle)
{
  // A long oblique tetrahedron with the inner cell near its far end: the way from there to the exterior below the
  // triangle (1, 2, 3) does not pass through that triangle.
  const std::vector<Point> centers{ NoPosition,      { { 0, 0, 0 } },   { { 1, 0, 0 } },
                                    { { 0, 1, 0 } }, { { 10, 10, 1 } }, { { 9.03, 9.03, 0.9 } } };
  const AdjacencyComplex   complex(6, DividedTetrahedron());
  for (const VertexQuadruple & t : complex.GetTetrahedra())
  {
    if (t[0] != ExteriorVertex)
    {
      const Point edge = centers[t[1]] - centers[t[0]];
      EXPECT_LT(0, Dot(edge, Cross(centers[t[2]] - centers[t[0]], centers[t[3]] - centers[t[0]])));
    }
  }
  EXPECT_EQ(Verdicts(DividedTetrahedron(), centers, { { 1, 2, 3 } }), GeometricallyInverted);
}

TEST(TriangleSwap, ExteriorInTheTriangleFillsAConcaveEdgeAndNotAConvexOne)
{
  // The surface edge (2, 4) of the bipyramid, between the surface triangles to 3 and to 5.
  const VertexTriple triangle{ { ExteriorVertex, 2, 4 } };
  EXPECT_EQ(Verdicts(Bipyramid(4),
                     BipyramidCenters({ { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { -1, 0, 0 } }, { { 0, -1, 0 } } }),
                     triangle),
            GeometricallyInverted);
  // With 4 drawn back, the segment from 3 to 5 passes outside of the edge.
  EXPECT_EQ(
    Verdicts(Bipyramid(4),
             BipyramidCenters({ { { 1, 0.4, 0.3 } }, { { 0, 0.3, 0 } }, { { -1, 0.4, 0.3 } }, { { 0, -1, 0 } } }),
             triangle),
    BothLegal);
}
