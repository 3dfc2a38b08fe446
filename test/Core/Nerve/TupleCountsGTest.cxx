/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/TupleCounts.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace tissue;

namespace
{
/** Counts the tuples as a map does, and compares. */
template <std::size_t VLength, typename TMakeKey>
void
ExpectCountsOfMap(const TMakeKey & makeKey)
{
  TupleCounts<VLength>                                       counts;
  std::map<typename TupleCounts<VLength>::Key, std::int32_t> expected;
  for (int i = 0; i < 20000; ++i)
  {
    const auto key = makeKey();
    ++counts[key].present;
    ++expected[key];
  }
  ASSERT_EQ(counts.GetEntries().size(), expected.size());
  for (const auto & [key, number] : expected)
  {
    ASSERT_EQ(counts.Get(key).present, number);
    ASSERT_EQ(counts.GetEntries()[static_cast<std::size_t>(counts.IndexOf(key))].key, key);
  }
  for (int i = 0; i < 1000; ++i)
  {
    const auto key = makeKey();
    if (expected.count(key) == 0)
    {
      EXPECT_EQ(counts.IndexOf(key), -1);
      EXPECT_EQ(counts.Get(key).present, 0);
    }
  }
}

TEST(TupleCounts, CountsAsAMapDoes)
{
  std::mt19937                            engine(1);
  std::uniform_int_distribution<VertexId> vertex(0, 300);
  ExpectCountsOfMap<2>([&] {
    const VertexId u = vertex(engine);
    return VertexPair{ { u, u + 1 + vertex(engine) } };
  });
  ExpectCountsOfMap<4>([&] {
    const VertexId u = vertex(engine);
    return VertexQuadruple{ { u, u + 1, u + 2 + vertex(engine) / 100, u + 10 } };
  });
}

TEST(TupleCounts, FindsRoomForAVertexWithManyNeighbors)
{
  constexpr VertexId                      giant = 1000000;
  std::mt19937                            engine(2);
  std::uniform_int_distribution<VertexId> vertex(0, giant - 1);
  ExpectCountsOfMap<2>([&] { return VertexPair{ { vertex(engine), giant } }; });
  ExpectCountsOfMap<4>([&] {
    const VertexId u = vertex(engine) / 3;
    return VertexQuadruple{ { u, u + 1 + vertex(engine) / 3, giant, giant + 1 } };
  });
}
} // namespace
