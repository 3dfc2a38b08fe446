/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/ReferenceAdjacency.h"

#include <gtest/gtest.h>

using namespace tissue;

TEST(JunctionVotes, TellTheShareOfEachQuadruple)
{
  // In ascending order, which is not that of their largest vertices.
  const JunctionVotes votes(8,
                            { { { { 0, 1, 2, 7 } }, 0.25 }, { { { 0, 1, 3, 4 } }, 0.5 }, { { { 1, 2, 3, 5 } }, 1.0 } });
  EXPECT_FALSE(votes.IsEmpty());
  EXPECT_EQ(votes.Share({ { 7, 2, 0, 1 } }), 0.25);
  EXPECT_EQ(votes.Share({ { 0, 1, 3, 4 } }), 0.5);
  EXPECT_EQ(votes.Share({ { 5, 3, 2, 1 } }), 1.0);
  EXPECT_EQ(votes.Share({ { 0, 1, 2, 3 } }), 0.0);
  ASSERT_EQ(votes.List().size(), 3u);
  for (const JunctionVote & vote : votes.List())
  {
    EXPECT_EQ(votes.Share(vote.cells), vote.share);
  }
  EXPECT_TRUE(JunctionVotes(8, {}).IsEmpty());
}
