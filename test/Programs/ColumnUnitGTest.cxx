/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/ColumnUnit.h"

#include <gtest/gtest.h>

TEST(ColumnUnit, IsAPowerOfTheLengthAnAngleOrNone)
{
  EXPECT_EQ(tissue::ColumnUnit("CenterX", "µm"), "µm");
  EXPECT_EQ(tissue::ColumnUnit("SurfaceArea", "µm"), "µm²");
  EXPECT_EQ(tissue::ColumnUnit("Volume", "mm"), "mm³");
  EXPECT_EQ(tissue::ColumnUnit("MeanCurvature", "µm"), "1/µm");
  EXPECT_EQ(tissue::ColumnUnit("GaussianCurvature", "µm"), "1/µm²");
  EXPECT_EQ(tissue::ColumnUnit("MinimumDihedralAngle", "µm"), "°");
  EXPECT_EQ(tissue::ColumnUnit("Sphericity", "µm"), "");
  EXPECT_EQ(tissue::ColumnUnit("MajorAxisX", "µm"), "");
}

TEST(ColumnUnit, LengthsHaveTheSymbolOfTheirUnit)
{
  EXPECT_EQ(tissue::LengthSymbol("micrometres"), "µm");
  EXPECT_EQ(tissue::LengthSymbol("millimetres"), "mm");
  EXPECT_EQ(tissue::LengthSymbol("um"), "µm");
  EXPECT_EQ(tissue::LengthSymbol("nm"), "nm");
  EXPECT_EQ(tissue::LengthSymbol("voxels"), "voxel");
  EXPECT_EQ(tissue::LengthSymbol(""), "unit");
}
