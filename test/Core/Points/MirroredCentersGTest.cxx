/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/MirroredCenters.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

#include <set>

using namespace tissue;

namespace
{
const Box Cube{ { { 0.0, 0.0, 0.0 } }, { { 6.0, 6.0, 6.0 } } };
} // namespace

TEST(MirroredCenters, AreThePointsWhereNoneIsNearASide)
{
  const std::vector<Point> points{ { { 0.9, 3.0, 3.0 } }, { { 5.1, 5.1, 5.1 } } };
  const MirroredCenters    centers = MirrorAtSides(points, { 0.0, 2.0, 2.0 }, Cube);
  EXPECT_EQ(centers.positions.size(), 3u);
  EXPECT_EQ(centers.positions[2], points[1]);
  EXPECT_EQ(centers.originals, (std::vector<std::size_t>{ 0, 1, 2 }));
}

TEST(MirroredCenters, HaveOneImageAtASideThreeAtAnEdgeAndSevenAtACorner)
{
  const std::vector<Point> points{ { { 0.5, 3.0, 3.0 } }, { { 0.5, 5.5, 3.0 } }, { { 0.0, 6.0, 6.0 } } };
  const MirroredCenters    centers = MirrorAtSides(points, { 0.0, 2.0, 2.0, 2.0 }, Cube);
  std::vector<int>         images(4, -1);
  for (std::size_t v = 0; v < centers.positions.size(); ++v)
  {
    ++images[centers.originals[v]];
    EXPECT_EQ(centers.spacings[v], v == 0 ? 0.0 : 2.0);
    if (v > points.size())
    {
      EXPECT_FALSE(Overlap(Cube, { centers.positions[v], centers.positions[v] })) << v;
    }
  }
  EXPECT_EQ(images, (std::vector<int>{ 0, 1, 3, 7 }));
  EXPECT_NEAR(Distance(centers.positions[4], { { -0.5, 3.0, 3.0 } }), 0.04, 1e-12);
  // Not even of the point in the corner is an image at the same place.
  EXPECT_EQ(std::set<Point>(centers.positions.begin() + 1, centers.positions.end()).size(), 3u + 1 + 3 + 7);
}
