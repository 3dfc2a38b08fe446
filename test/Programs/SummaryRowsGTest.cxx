/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/SummaryRows.h"

#include "RefusalOf.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
using Records = std::vector<DelimitedText::Record>;

/** Rows of five points and others. */
Records
WithRows(const Records & others)
{
  Records rows;
  for (std::size_t i = 0; i < 5; ++i)
  {
    rows.push_back({ { "c", "1", "2", "3" }, i + 2 });
  }
  rows.insert(rows.end(), others.begin(), others.end());
  return rows;
}

std::string
Refusal(Records rows)
{
  return RefusalOf([&] { DropSummaryRows(rows); });
}
} // namespace

TEST(SummaryRows, AreDroppedAtTheEndWithAWarning)
{
  for (const std::string column : { "first", "last" })
  {
    Records others;
    for (const std::string word : { "Mean", "Std. Dev.", "Min", "max", "25%" })
    {
      const bool isFirst = column == "first";
      others.push_back({ { isFirst ? word : "", "1", "2", isFirst ? "3" : word }, 7 + others.size() });
    }
    Records rows = WithRows(others);
    EXPECT_EQ(DropSummaryRows(rows),
              (std::vector<std::string>{
                "lines 7, 8, 9, 10 and 11 left out: a summary ('Mean', 'Std. Dev.', 'Min', 'max', '25%')" }));
    EXPECT_EQ(rows.size(), 5u);
  }
  Records total = WithRows({ { { "Total", "5" }, 7 } });
  EXPECT_EQ(DropSummaryRows(total), (std::vector<std::string>{ "line 7 left out: a summary ('Total')" }));
  EXPECT_EQ(total.size(), 5u);
}

TEST(SummaryRows, WhatMayBeOneIsRefused)
{
  EXPECT_EQ(Refusal(WithRows({ { { "Max", "1", "2", "3" }, 7 } })),
            "line 7: 'Max' may be a row of summary, which is no point: delete it, or give the point another name");
  EXPECT_EQ(Refusal(WithRows({ { { "Average", "1", "2", "3" }, 7 }, { { "d", "1", "2", "3" }, 8 } })).substr(0, 17),
            "line 7: 'Average'");
}

TEST(SummaryRows, OthersStay)
{
  Records rows = WithRows({ { { "Max", "1", "2", "3" }, 7 }, { { "d", "1", "2", "3" }, 8 } });
  EXPECT_TRUE(DropSummaryRows(rows).empty());
  EXPECT_EQ(rows.size(), 7u);
  Records all(5, DelimitedText::Record{ { "mean", "1", "2", "3" }, 2 });
  EXPECT_TRUE(DropSummaryRows(all).empty());
  EXPECT_EQ(all.size(), 5u);
  Records none;
  EXPECT_TRUE(DropSummaryRows(none).empty());
}
