/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/KeySet.h"

#include <gtest/gtest.h>

using tissue::KeySet;

TEST(KeySet, HoldsEachKeyOnce)
{
  KeySet keys;
  EXPECT_FALSE(keys.Contains(0));
  for (std::int64_t key = 0; key < 1000; ++key)
  {
    EXPECT_TRUE(keys.Insert(key * 4096));
    EXPECT_FALSE(keys.Insert(key * 4096));
  }
  for (std::int64_t key = 0; key < 1000; ++key)
  {
    EXPECT_TRUE(keys.Contains(key * 4096));
    EXPECT_FALSE(keys.Contains(key * 4096 + 1));
  }
  keys.Clear();
  EXPECT_FALSE(keys.Contains(4096));
  EXPECT_TRUE(keys.Insert(4096));
}
