/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/ReferenceAdjacency.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace tissue_test;

TEST(ReferenceAdjacency, HoldsTheTuplesOfTheImageInAnyOrder)
{
  const AdjacencyComplex   complex(7, Bipyramid(4));
  const ReferenceAdjacency reference(JunctionsOf(complex, BipyramidCenters(std::vector<Point>(4))));
  EXPECT_EQ(reference.NumberOfPairs(), complex.NumberOfEdges());
  EXPECT_EQ(reference.NumberOfQuadruples(), complex.NumberOfTetrahedra());
  for (VertexId u = 0; u < 7; ++u)
  {
    for (VertexId v = 0; v < 7; ++v)
    {
      EXPECT_EQ(reference.HasPair(u, v), u != v && complex.FindEdge(u, v) != nullptr) << u << " " << v;
    }
  }
  VertexQuadruple t{ { 1, 2, 5, 6 } };
  do
  {
    EXPECT_TRUE(reference.HasQuadruple(t));
  } while (std::next_permutation(t.begin(), t.end()));
  EXPECT_TRUE(reference.HasQuadruple({ { 0, 2, 3, 4 } }));
  EXPECT_FALSE(reference.HasQuadruple({ { 1, 2, 3, 5 } }));
  EXPECT_FALSE(reference.HasQuadruple({ { 0, 1, 2, 3 } }));
}

TEST(ReferenceAdjacency, RenumberedHoldsTheSameTuplesByTheirNewIds)
{
  const AdjacencyComplex      complex(7, Bipyramid(4));
  const ReferenceAdjacency    reference(JunctionsOf(complex, BipyramidCenters(std::vector<Point>(4))));
  const std::vector<VertexId> ids{ 0, 4, 6, 2, 1, 5, 3 };
  const ReferenceAdjacency    renumbered = reference.Renumbered(ids);
  ASSERT_EQ(renumbered.NumberOfQuadruples(), reference.NumberOfQuadruples());
  ASSERT_EQ(renumbered.NumberOfPairs(), reference.NumberOfPairs());
  for (const VertexQuadruple & q : reference.GetQuadruples())
  {
    EXPECT_TRUE(renumbered.HasQuadruple({ { ids[q[0]], ids[q[1]], ids[q[2]], ids[q[3]] } }));
  }
  for (const VertexPair & pair : reference.GetPairs())
  {
    EXPECT_TRUE(renumbered.HasPair(ids[pair[0]], ids[pair[1]]));
  }
}
