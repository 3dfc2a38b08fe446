/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/ComplexValidity.h"
#include "Complex/LocalOperations.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

TEST(VertexMoves, InsertionAndRemovalAreEachOthersInverse)
{
  const auto             centers = RandomCenters(20, 5);
  const AdjacencyComplex complex = DelaunayComplex(centers);
  // A vertex that is in no tetrahedron yet: one more than the complex of the first cells has.
  const auto            tetrahedra = complex.GetTetrahedra();
  const VertexId        added = complex.NumberOfVertices();
  AdjacencyComplex      larger(added + 1, tetrahedra);
  const LocalOperations largerOperations(larger, centers, Legality::Combinatorial);

  const Proposal insertion = largerOperations.InsertVertex(added, 0);
  ASSERT_TRUE(insertion);
  EXPECT_EQ(insertion.replacement.removed.size(), 1u);
  EXPECT_EQ(insertion.replacement.created.size(), 4u);
  EXPECT_EQ(insertion.replacement.createdEdges.size(), 4u);
  larger.Apply(insertion.replacement);
  EXPECT_TRUE(FindViolations(larger).empty());
  EXPECT_EQ(larger.NumberOfNeighbors(added), 4);

  const Proposal removal = largerOperations.RemoveVertex(added);
  ASSERT_TRUE(removal);
  larger.Apply(removal.replacement);
  EXPECT_EQ(larger.GetTetrahedra(), tetrahedra);
  EXPECT_EQ(larger.NumberOfNeighbors(added), 0);
}

TEST(VertexMoves, RemovalIsRefusedForMoreThanFourNeighbors)
{
  const std::vector<Point> centers(7);
  const AdjacencyComplex   complex(6, Bipyramid(3)); // every two of its six vertices are adjacent
  const LocalOperations    operations(complex, centers, Legality::Combinatorial);
  EXPECT_EQ(operations.RemoveVertex(1).verdict, Verdict::TooManyNeighbors);
}

TEST(VertexMoves, RemovalIsRefusedWhereTheTetrahedronExists)
{
  // In the boundary of the 4-simplex the other four vertices are a tetrahedron already.
  const std::vector<Point> centers(5);
  const AdjacencyComplex   complex(5, FourSimplex());
  const LocalOperations    operations(complex, centers, Legality::Combinatorial);
  EXPECT_EQ(operations.RemoveVertex(1).verdict, Verdict::TetrahedronExists);
}
