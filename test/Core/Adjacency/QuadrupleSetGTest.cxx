/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/QuadrupleSet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

using namespace tissue;

TEST(QuadrupleSet, FindsEachOfItsQuadruplesInAnyOrderAtItsPlaceAndNoOther)
{
  const std::vector<VertexQuadruple> quadruples{ { 0, 1, 2, 7 }, { 0, 1, 3, 4 }, { 1, 2, 3, 4 }, { 2, 3, 4, 7 } };
  const QuadrupleSet                 set(8, quadruples);
  const std::vector<VertexQuadruple> list = set.List();
  ASSERT_EQ(set.Size(), 4u);
  EXPECT_TRUE(std::is_permutation(list.begin(), list.end(), quadruples.begin(), quadruples.end()));
  std::size_t found = 0;
  for (VertexId i = 0; i < 8 * 8 * 8 * 8; ++i)
  {
    const VertexQuadruple q{ { i % 8, i / 8 % 8, i / 64 % 8, i / 512 } };
    VertexQuadruple       sorted = q;
    std::sort(sorted.begin(), sorted.end());
    const auto at = std::find(list.begin(), list.end(), sorted);
    EXPECT_EQ(set.Find(q), at == list.end() ? QuadrupleSet::NotFound : at - list.begin());
    found += set.Find(q) != QuadrupleSet::NotFound ? 1 : 0;
  }
  EXPECT_EQ(found, 4u * 24u);
}

TEST(QuadrupleSet, MayBeEmpty)
{
  EXPECT_EQ(QuadrupleSet(5, {}).Find({ { 1, 2, 3, 4 } }), QuadrupleSet::NotFound);
  EXPECT_TRUE(QuadrupleSet(0, {}).List().empty());
}

TEST(QuadrupleSet, RefusesMoreCellsThanItHasBitsFor)
{
  EXPECT_THROW(QuadrupleSet((1 << 21) + 1, {}), std::invalid_argument);
}
