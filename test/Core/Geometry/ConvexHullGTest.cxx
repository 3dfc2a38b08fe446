/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/ConvexHull.h"

#include <gtest/gtest.h>

using namespace tissue;

TEST(ConvexHull, VolumesByHand)
{
  std::vector<Point> cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.push_back({ { 10.0 + i % 2, 20.0 + i / 2 % 2, 30.0 + i / 4 } });
  }
  EXPECT_NEAR(ConvexHullVolume(cube), 1.0, 1e-12);
  cube.push_back({ { 10.5, 20.5, 30.5 } });
  EXPECT_NEAR(ConvexHullVolume(cube), 1.0, 1e-12) << "a point within";
  EXPECT_NEAR(ConvexHullVolume({ { { 0, 0, 0 } }, { { 3, 0, 0 } }, { { 0, 2, 0 } }, { { 0, 0, 1 } } }), 1.0, 1e-12);
}

TEST(ConvexHull, PointsInAPlaneHaveNone)
{
  EXPECT_EQ(ConvexHullVolume({ { { 0, 0, 0 } }, { { 3, 0, 0 } }, { { 0, 2, 0 } }, { { 3, 2, 0 } } }), 0.0);
}
