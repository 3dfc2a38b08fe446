/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/ReferenceAdjacency.h"
#include "TestComplexes.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace tissue_test;

TEST(AdjacencyOverlap, JaccardByHand)
{
  EXPECT_DOUBLE_EQ(Jaccard(2, 3, 5), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(Jaccard(0, 3, 5), 0.0);
  EXPECT_DOUBLE_EQ(Jaccard(4, 4, 4), 1.0);
  EXPECT_DOUBLE_EQ(Jaccard(0, 0, 0), 0.0);
}

TEST(AdjacencyOverlap, OverlapByHand)
{
  const AdjacencyComplex complex(6, Bipyramid(3));
  JunctionSet            junctions = JunctionsOf(complex, BipyramidCenters(std::vector<Point>(3)));
  EXPECT_DOUBLE_EQ(
    ComputeAdjacencyOverlap(AdjacencyTuples::Of(complex.GetTetrahedra()), ReferenceAdjacency(junctions)).adjacency2,
    1.0);
  EXPECT_DOUBLE_EQ(
    ComputeAdjacencyOverlap(AdjacencyTuples::Of(complex.GetTetrahedra()), ReferenceAdjacency(junctions)).adjacency4,
    1.0);
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(AdjacencyTuples::Of(complex.GetTetrahedra()), ReferenceAdjacency(junctions))
                     .adjacency4OfNeighbors,
                   1.0);

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
  const AdjacencyOverlap overlap =
    ComputeAdjacencyOverlap(AdjacencyTuples::Of(complex.GetTetrahedra()), ReferenceAdjacency(junctions));
  EXPECT_DOUBLE_EQ(overlap.adjacency2, 13.0 / 15.0);
  EXPECT_DOUBLE_EQ(overlap.adjacency4, 7.0 / 10.0);
  // The pairs that the image lacks are of the exterior and of cells of the ring: three quadruples have neither.
  EXPECT_DOUBLE_EQ(overlap.adjacency4OfNeighbors, 3.0 / 9.0);
  EXPECT_EQ(overlap.numberOfFalsePairs, 2u);
  EXPECT_EQ(overlap.numberOfMissingPairs, 0u);
}

TEST(AdjacencyOverlap, OverlapOfTetrahedraOverOtherVertices)
{
  const AdjacencyComplex       complex(6, Bipyramid(3));
  const JunctionSet            image = JunctionsOf(complex, BipyramidCenters(std::vector<Point>(3)));
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
  const AdjacencyTuples tuples = AdjacencyTuples::Of(tetrahedra);
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(tuples, ids, image).adjacency2, 1.0);
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(tuples, ids, image).adjacency4, 1.0);

  // A vertex without a counterpart has five of the 15 pairs, and so many of the nine quadruples.
  std::vector<VertexId> unknown = ids;
  unknown[idsBack[5]] = -1;
  const auto has = [](const Junction & junction) { return junction.cells[3] == 5; };
  const auto lost = static_cast<double>(std::count_if(image.junctions.begin(), image.junctions.end(), has));
  ASSERT_GT(lost, 2.0);
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(tuples, unknown, image).adjacency2, 10.0 / 20.0);
  EXPECT_DOUBLE_EQ(ComputeAdjacencyOverlap(tuples, unknown, image).adjacency4, (9.0 - lost) / (9.0 + lost));
  EXPECT_EQ(ComputeAdjacencyOverlap(tuples, unknown, image).numberOfFalsePairs, 5u);
  EXPECT_EQ(ComputeAdjacencyOverlap(tuples, unknown, image).numberOfMissingPairs, 5u);
}
