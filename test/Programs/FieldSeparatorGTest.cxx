/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/FieldSeparator.h"

#include <gtest/gtest.h>

using namespace tissue;

TEST(FieldSeparator, IsTheOneOfMostLinesOfOneNumberOfFields)
{
  EXPECT_EQ(FindSeparator("x,y,z\n1,2,3\n"), ',');
  EXPECT_EQ(FindSeparator("x;y;z\n1,5;2,5;3,5\n"), ';');
  EXPECT_EQ(FindSeparator("1,5;2,5;3,5\n1,5;2,5;3,5\n"), ';');
  EXPECT_EQ(FindSeparator("x\ty\tz\n1,5\t2,5\t3\n"), '\t');
  EXPECT_EQ(FindSeparator("  x y   z\n 1  2 3  \n"), ' ');
  EXPECT_EQ(FindSeparator("Position X, Position Y, Position Z\n1, 2, 3\n"), ',');
  EXPECT_EQ(FindSeparator("a title; with; many; signs;\nx,y,z\n1,2,3\n"), ',');
  EXPECT_EQ(FindSeparator("x|y|z\n1,5|2,5|3,5\n"), '|');
  EXPECT_EQ(FindSeparator("cell one,1,2,3\ncell two,1,2,3\n"), ',');
}

TEST(FieldSeparator, QuotesEmptyLinesAndCommentsDoNotCount)
{
  EXPECT_EQ(FindSeparator("\"a;b;c;d\",y,z\n1,2,3\n"), ',');
  EXPECT_EQ(FindSeparator("# a;b;c\n# a;b;c\n\n\n% a;b;c\nx,y,z\n"), ',');
  EXPECT_EQ(FindSeparator(""), ',');
  EXPECT_EQ(FindSeparator("x\n1\n"), ',');
  EXPECT_EQ(FindSeparator("x;y\n1;2\n"), ';');
}
