/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallPatch.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace tissue;

TEST(PatchMeasures, ASquareAroundItsMiddle)
{
  const std::vector<Point> points = {
    { { 0, 0, 0 } }, { { 2, 0, 0 } }, { { 2, 2, 0 } }, { { 0, 2, 0 } }, { { 1, 1, 0 } }
  };
  WallPatch patch(points, { { { 4, 0, 1 } }, { { 4, 1, 2 } }, { { 4, 2, 3 } }, { { 4, 3, 0 } } }, 4);
  EXPECT_DOUBLE_EQ(AreaOf(patch), 4.0);
  EXPECT_DOUBLE_EQ(MeanQuality(patch), 0.5 * std::sqrt(3.0)) << "right isosceles triangles";
  // Two triangles are left, and two that are gone do not count.
  patch.Collapse(patch.Leaving(4));
  EXPECT_DOUBLE_EQ(AreaOf(patch), 4.0);
  EXPECT_DOUBLE_EQ(MeanQuality(patch), 0.5 * std::sqrt(3.0));
}

TEST(PatchMeasures, NothingOfNothing)
{
  const WallPatch patch({}, {}, 0);
  EXPECT_EQ(AreaOf(patch), 0.0);
  EXPECT_EQ(MeanQuality(patch), 0.0);
}
