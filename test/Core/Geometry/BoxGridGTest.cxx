/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/BoxGrid.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

namespace
{
using namespace tissue;
using Pair = std::array<std::int32_t, 2>;

std::vector<Box>
MakeBoxes(std::size_t count, double edge)
{
  Random           random(1);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point p{ { random.Uniform(), random.Uniform(), random.Uniform() } };
    boxes.push_back({ p, p + Point{ { edge, edge * random.Uniform(), edge } } });
  }
  return boxes;
}

std::vector<Pair>
FindPairs(const std::vector<Box> & boxes)
{
  const BoxGrid     grid(boxes);
  std::vector<Pair> pairs;
  for (std::int64_t layer = 0; layer < grid.NumberOfLayers(); ++layer)
  {
    grid.VisitPairs(layer, [&pairs](std::int32_t a, std::int32_t b) { pairs.push_back({ { a, b } }); });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Pair>
FindPairsOneByOne(const std::vector<Box> & boxes)
{
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < boxes.size(); ++a)
  {
    for (std::size_t b = a + 1; b < boxes.size(); ++b)
    {
      if (Overlap(boxes[a], boxes[b]))
      {
        pairs.push_back({ { static_cast<std::int32_t>(a), static_cast<std::int32_t>(b) } });
      }
    }
  }
  return pairs;
}
} // namespace

TEST(BoxGrid, FindsEachPairOnce)
{
  std::vector<Box> boxes = MakeBoxes(500, 0.1);
  EXPECT_GT(FindPairs(boxes).size(), 100u);
  EXPECT_EQ(FindPairs(boxes), FindPairsOneByOne(boxes));
  // Points, and all at one place.
  boxes = MakeBoxes(100, 0.0);
  EXPECT_TRUE(FindPairs(boxes).empty());
  EXPECT_EQ(FindPairs(std::vector<Box>(20, boxes[0])).size(), 190u);
  EXPECT_TRUE(FindPairs({ boxes[0] }).empty());
}

TEST(BoxGrid, FindsThePairsOfSmallBoxesFarFromTheOrigin)
{
  // A float tells no box from the next here.
  std::vector<Box> boxes = MakeBoxes(500, 0.1);
  const Point      far{ { 1e9, -1e9, 1e9 } };
  for (Box & box : boxes)
  {
    box = { box.lower + far, box.upper + far };
  }
  EXPECT_EQ(FindPairs(boxes), FindPairsOneByOne(boxes));
}

TEST(BoxGrid, FindsBoxesThatTouch)
{
  std::vector<Box> boxes;
  for (int i = 0; i < 100; ++i)
  {
    boxes.push_back({ { { 0.1 * i, 0.3, 0.7 } }, { { 0.1 * (i + 1), 0.9, 1.1 } } });
    boxes.back().lower[0] = i > 0 ? boxes[boxes.size() - 2].upper[0] : 0.0;
  }
  EXPECT_EQ(FindPairs(boxes).size(), 99u);
}

TEST(BoxGrid, FindsThePairsOfBoxesFarLongerThanTheOthers)
{
  std::vector<Box> boxes = MakeBoxes(1000, 0.01);
  boxes[7] = { { { -1e6, -1e6, -1e6 } }, { { 1e6, 1e6, 1e6 } } };
  boxes[500] = { { { -1e6, -1e6, 0.5 } }, { { 1e6, 1e6, 0.5 } } };
  EXPECT_EQ(FindPairs(boxes), FindPairsOneByOne(boxes));
  // As many layers as without them: the others are not in a few cells.
  const auto layers = BoxGrid(boxes).NumberOfLayers();
  EXPECT_GE(layers, 15);
}

TEST(BoxGrid, FindsEachPairOfDifferentGroupsOnce)
{
  const std::vector<Box>    boxes = MakeBoxes(500, 0.1);
  std::vector<std::int32_t> groups(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    groups[i] = static_cast<std::int32_t>(i < 400 ? i / 50 : i);
  }
  const BoxGrid     grid(boxes, groups);
  std::vector<Pair> pairs;
  for (std::int64_t layer = 0; layer < grid.NumberOfLayers(); ++layer)
  {
    grid.VisitPairs(layer, [&](std::int32_t a, std::int32_t b) { pairs.push_back({ { a, b } }); });
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<Pair> expected;
  for (const Pair & pair : FindPairsOneByOne(boxes))
  {
    if (groups[pair[0]] != groups[pair[1]])
    {
      expected.push_back(pair);
    }
  }
  EXPECT_EQ(pairs, expected);
}
