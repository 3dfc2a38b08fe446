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

using namespace testing_complexes;

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

TEST(ReferenceAdjacency, JaccardByHand)
{
  EXPECT_DOUBLE_EQ(Jaccard(2, 3, 5), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(Jaccard(0, 3, 5), 0.0);
  EXPECT_DOUBLE_EQ(Jaccard(4, 4, 4), 1.0);
  EXPECT_DOUBLE_EQ(Jaccard(0, 0, 0), 0.0);
}

TEST(ReferenceAdjacency, OverlapByHand)
{
  const AdjacencyComplex complex(6, Bipyramid(3));
  JunctionSet            junctions = JunctionsOf(complex, BipyramidCenters(std::vector<Point>(3)));
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(complex, ReferenceAdjacency(junctions)).adjacency2, 1.0);
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(complex, ReferenceAdjacency(junctions)).adjacency4, 1.0);

  // Of 15 pairs (all of six vertices) and 9 quadruples the image lacks two each, and it has one quadruple more.
  ASSERT_EQ(junctions.walls.size(), 15u);
  ASSERT_EQ(junctions.junctions.size(), 9u);
  junctions.walls.erase(junctions.walls.begin() + 3, junctions.walls.begin() + 5);
  junctions.junctions.erase(junctions.junctions.begin(), junctions.junctions.begin() + 2);
  Junction more;
  more.cells = { { 0, 3, 4, 5 } };
  const auto at = std::find_if(junctions.junctions.begin(),
                               junctions.junctions.end(),
                               [&more](const Junction & junction) { return more.cells < junction.cells; });
  junctions.junctions.insert(at, more);
  std::sort(junctions.junctions.begin(), junctions.junctions.end(), [](const Junction & a, const Junction & b) {
    return a.cells < b.cells;
  });
  const AdjacencyOverlap overlap = ComputeAdjacencyOverlap(complex, ReferenceAdjacency(junctions));
  EXPECT_DOUBLE_EQ(overlap.adjacency2, 13.0 / 15.0);
  EXPECT_DOUBLE_EQ(overlap.adjacency4, 7.0 / 10.0);
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

TEST(ReferenceAdjacency, IsAsSureOfQuadruplesAsTheVotesWhereThereAreSome)
{
  const AdjacencyComplex      complex(6, Bipyramid(3));
  JunctionSet                 junctions = JunctionsOf(complex, BipyramidCenters(std::vector<Point>(3)));
  const VertexQuadruple       known = junctions.junctions.front().cells;
  const std::vector<VertexId> ids{ 0, 4, 5, 2, 1, 3 };
  const ReferenceAdjacency    without(junctions);
  EXPECT_FALSE(without.HasVotes());
  EXPECT_EQ(without.Certainty(known), 1.0);
  EXPECT_EQ(without.Certainty({ { 0, 3, 4, 5 } }), 0.0);

  junctions.votes = { { { { 0, 1, 3, 5 } }, 0.75 }, { { { 0, 3, 4, 5 } }, 0.25 } };
  for (const bool isRenumbered : { false, true })
  {
    const ReferenceAdjacency reference =
      isRenumbered ? ReferenceAdjacency(junctions).Renumbered(ids) : ReferenceAdjacency(junctions);
    const auto certainty = [&](const VertexQuadruple & q) {
      return reference.Certainty(isRenumbered ? VertexQuadruple{ { ids[q[0]], ids[q[1]], ids[q[2]], ids[q[3]] } } : q);
    };
    EXPECT_TRUE(reference.HasVotes());
    EXPECT_EQ(certainty({ { 0, 1, 3, 5 } }), 0.75);
    EXPECT_EQ(certainty({ { 0, 3, 4, 5 } }), 0.25);
    EXPECT_EQ(certainty({ { 0, 1, 2, 4 } }), 0.0);
  }
}

TEST(ReferenceAdjacency, OverlapOfTetrahedraOverOtherVertices)
{
  const AdjacencyComplex       complex(6, Bipyramid(3));
  const ReferenceAdjacency     reference(JunctionsOf(complex, BipyramidCenters(std::vector<Point>(3))));
  std::vector<VertexQuadruple> tetrahedra = complex.GetTetrahedra();
  // The same vertices by other ids, one tetrahedron twice.
  const std::vector<VertexId> ids{ 0, 3, 1, 5, 2, 4 };
  std::vector<VertexId>       idsBack(6);
  for (VertexId v = 0; v < 6; ++v)
  {
    idsBack[ids[v]] = v;
  }
  for (VertexQuadruple & t : tetrahedra)
  {
    t = { { idsBack[t[0]], idsBack[t[1]], idsBack[t[2]], idsBack[t[3]] } };
  }
  tetrahedra.push_back(tetrahedra.front());
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(tetrahedra, ids, reference).adjacency2, 1.0);
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(tetrahedra, ids, reference).adjacency4, 1.0);

  // A vertex without a counterpart has five of the 15 pairs, and so many of the nine quadruples.
  std::vector<VertexId> unknown = ids;
  unknown[idsBack[5]] = -1;
  const auto has = [](const Junction & junction) { return junction.cells[3] == 5; };
  const auto junctions = JunctionsOf(complex, BipyramidCenters(std::vector<Point>(3))).junctions;
  const auto lost = static_cast<double>(std::count_if(junctions.begin(), junctions.end(), has));
  ASSERT_GT(lost, 2.0);
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(tetrahedra, unknown, reference).adjacency2, 10.0 / 20.0);
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(tetrahedra, unknown, reference).adjacency4, (9.0 - lost) / (9.0 + lost));
}
