/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Statistics/SolidMoments.h"

#include "Balls.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace tissue;

const double Pi = std::acos(-1.0);
} // namespace

TEST(SolidMoments, OfABoxAreThoseOfItsSides)
{
  WallMesh mesh = MakeVoxelWallMesh({ { 2, 3, 5 } }, std::vector<VertexId>(30, 1));
  for (Point & p : mesh.points)
  {
    p = p + Point{ { 1000, -2000, 3000 } };
  }
  const auto solids = MeasureSolids(mesh, 2);
  EXPECT_EQ(solids[0].area, 0.0);
  EXPECT_EQ(solids[0].volume, 0.0);
  EXPECT_NEAR(solids[1].area, 62.0, 1e-9);
  EXPECT_NEAR(solids[1].volume, 30.0, 1e-9);
  EXPECT_LT(Distance(solids[1].centroid, { { 1001, -1998.5, 3002.5 } }), 1e-9);
  const Metric expected{ { 4.0 / 12, 0, 0, 9.0 / 12, 0, 25.0 / 12 } };
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(solids[1].covariance[i], expected[i], 1e-9) << i;
  }
}

TEST(SolidMoments, OfTheSecondCellOfAWallAreOutwards)
{
  const auto solids = MeasureSolids(MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 }), 3);
  EXPECT_NEAR(solids[1].volume, 1.0, 1e-12);
  EXPECT_NEAR(solids[2].volume, 1.0, 1e-12);
  EXPECT_LT(Distance(solids[2].centroid, { { 1.5, 0.5, 0.5 } }), 1e-12);
  EXPECT_NEAR(solids[2].covariance[0], 1.0 / 12, 1e-12);
}

TEST(SolidMoments, OfAnEllipsoidAreAFifthOfItsSquaredSemiAxes)
{
  const WallMesh mesh =
    tissue_test::Ellipsoid({ { 1, 2, 4 } }, { { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } }, { { 5, 6, 7 } });
  const auto solids = MeasureSolids(mesh, 2);
  EXPECT_NEAR(solids[1].volume, 4.0 / 3.0 * Pi * 8.0, 0.3);
  EXPECT_LT(Distance(solids[1].centroid, { { 5, 6, 7 } }), 1e-9);
  EXPECT_NEAR(solids[1].covariance[0], 0.2, 0.002);
  EXPECT_NEAR(solids[1].covariance[3], 0.8, 0.008);
  EXPECT_NEAR(solids[1].covariance[5], 3.2, 0.032);
}

TEST(SolidMoments, WithoutVolumeThereIsNoCentroid)
{
  WallMesh mesh = MakeVoxelWallMesh({ { 1, 1, 1 } }, { 1 });
  for (Triangle & triangle : mesh.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  const auto solids = MeasureSolids(mesh, 3);
  EXPECT_NEAR(solids[1].volume, -1.0, 1e-12);
  EXPECT_NEAR(solids[1].area, 6.0, 1e-12);
  EXPECT_EQ(solids[1].covariance, Metric());
  EXPECT_EQ(solids[2].area, 0.0);
}
