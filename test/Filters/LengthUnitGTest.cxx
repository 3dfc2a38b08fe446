/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LengthUnit.h"

#include <gtest/gtest.h>

using tissue::ToMicrometers;

TEST(LengthUnit, KnowsWhatProgramsWrite)
{
  for (const char * micrometer : { "um",
                                   "\xC2\xB5m",
                                   "\xCE\xBCm",
                                   "\xB5m",
                                   "\\u00B5m",
                                   "micron",
                                   "microns",
                                   "Micrometer",
                                   "micrometres",
                                   " um\r" })
  {
    EXPECT_EQ(ToMicrometers(micrometer), 1.0) << micrometer;
  }
  EXPECT_EQ(ToMicrometers("nm"), 1e-3);
  EXPECT_EQ(ToMicrometers("mm"), 1e3);
  EXPECT_EQ(ToMicrometers("cm"), 1e4);
  EXPECT_EQ(ToMicrometers("meters"), 1e6);
  EXPECT_EQ(ToMicrometers("inches"), 25400.0);
  EXPECT_EQ(ToMicrometers("\xC3\x85"), 1e-4);
}

TEST(LengthUnit, TakesNothingElseForALength)
{
  for (const char * other : { "", "pixel", "pixels", "s", "sec", "reference frame", "voxel" })
  {
    EXPECT_EQ(ToMicrometers(other), std::nullopt) << other;
  }
}
