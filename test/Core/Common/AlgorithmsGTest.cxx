/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Common/Algorithms.h"

#include <gtest/gtest.h>

TEST(Algorithms, TheMedianIsTheMiddleOneOrTheUpperOfTwo)
{
  EXPECT_EQ(tissue::Median({ 5.0 }), 5.0);
  EXPECT_EQ(tissue::Median({ 9.0, -1.0, 4.0 }), 4.0);
  EXPECT_EQ(tissue::Median({ 3.0, 1.0, 2.0, 4.0 }), 3.0);
}
