/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/ExactPredicates.h"

#include <gtest/gtest.h>

TEST(ExactPredicates, OrientationIsTheSignOfTheDeterminant)
{
  const tissue::Point origin{ { 0, 0, 0 } };
  const tissue::Point x{ { 1, 0, 0 } };
  const tissue::Point y{ { 0, 1, 0 } };
  const tissue::Point z{ { 0, 0, 1 } };
  EXPECT_EQ(tissue::Orientation(origin, x, y, z), 1);
  EXPECT_EQ(tissue::Orientation(origin, y, x, z), -1);
}

TEST(ExactPredicates, CoplanarPointsAreFoundWhereRoundingWouldHideThem)
{
  // On the plane x + y + z = 0 exactly, with coordinates of very different magnitude.
  const tissue::Point a{ { 1e17, -1e17, 0 } };
  const tissue::Point b{ { 1, -1, 0 } };
  const tissue::Point c{ { 0, 3, -3 } };
  tissue::Point       d{ { 0.5, 0.25, -0.75 } };
  EXPECT_EQ(tissue::Orientation(a, b, c, d), 0);
  d[2] = -0.75 + 1e-16;
  EXPECT_NE(tissue::Orientation(a, b, c, d), 0);
}
