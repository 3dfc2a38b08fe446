/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Common/CompressedRows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

namespace
{
using Rows = tissue::CompressedRows<std::int32_t, std::int32_t>;
using Row = std::vector<std::int32_t>;

Row
RowOf(const Rows & rows, std::size_t key)
{
  return Row(rows[key].begin(), rows[key].end());
}

Rows
Group(std::size_t numberOfRows, const std::vector<std::size_t> & keys)
{
  return Rows(numberOfRows, [&keys](const auto & add) {
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      add(keys[i], static_cast<std::int32_t>(i));
    }
  });
}
} // namespace

TEST(CompressedRows, GroupsItemsInTheirOrder)
{
  const Rows rows = Group(4, { 2, 0, 2, 3, 2 });
  ASSERT_EQ(rows.NumberOfRows(), 4u);
  EXPECT_EQ(RowOf(rows, 0), (Row{ 1 }));
  EXPECT_EQ(RowOf(rows, 1), (Row{}));
  EXPECT_EQ(RowOf(rows, 2), (Row{ 0, 2, 4 }));
  EXPECT_EQ(RowOf(rows, 3), (Row{ 3 }));
  EXPECT_EQ(rows[2].size(), 3u);
  EXPECT_EQ(rows.Items(), (Row{ 1, 0, 2, 4, 3 }));
}

TEST(CompressedRows, HasNoRowsAtFirstAndEmptyRowsWithoutItems)
{
  EXPECT_EQ(Rows().NumberOfRows(), 0u);
  EXPECT_EQ(Group(0, {}).NumberOfRows(), 0u);
  const Rows rows = Group(2, {});
  EXPECT_EQ(rows.NumberOfRows(), 2u);
  EXPECT_EQ(rows[0].size() + rows[1].size(), 0u);
}

TEST(CompressedRows, AssignForgetsWhatWasThere)
{
  Rows rows = Group(3, { 0, 1, 2, 2 });
  rows.Assign(1, [](const auto & add) { add(0, 7); });
  EXPECT_EQ(rows.NumberOfRows(), 1u);
  EXPECT_EQ(RowOf(rows, 0), (Row{ 7 }));
}

TEST(CompressedRows, ItemsOfARowCanBeChanged)
{
  Rows       rows = Group(2, { 0, 1, 0 });
  const auto row = rows[0];
  std::reverse(row.begin(), row.end());
  EXPECT_EQ(rows.Items(), (Row{ 2, 0, 1 }));
}

TEST(CompressedRows, IsAStableSortByKeys)
{
  std::mt19937             random(1);
  std::vector<std::size_t> keys(1000);
  std::generate(keys.begin(), keys.end(), [&random]() { return random() % 100; });
  Row sorted(keys.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    sorted[i] = static_cast<std::int32_t>(i);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [&keys](int a, int b) { return keys[a] < keys[b]; });
  EXPECT_EQ(Group(100, keys).Items(), sorted);
}
