/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Geometry/PointRange.h"

#include <gtest/gtest.h>

TEST(PointRange, FindsTheFirstPointOutside)
{
  const tissue::Box box{ { { 0.0, 0.0, 0.0 } }, { { 1.0, 2.0, 3.0 } } };
  EXPECT_FALSE(tissue::FindPointOutside({}, box));
  EXPECT_FALSE(tissue::FindPointOutside({ { { 0.0, 2.0, 1.0 } }, { { 1.0, 0.0, 3.0 } } }, box));
  EXPECT_EQ(tissue::FindPointOutside({ { { 0.5, 1.0, 1.0 } }, { { 0.5, 2.1, 1.0 } }, { { -1.0, 0.0, 0.0 } } }, box),
            1u);
}
