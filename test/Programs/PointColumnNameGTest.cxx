/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointColumnName.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
/** Axis, unit and rank in one text; empty if the name is no axis. */
std::string
Parse(const std::string & name)
{
  const auto axis = ParseAxisName(name);
  return axis ? std::string(1, "xyz"[axis->axis]) + ' ' + axis->unit + ' ' + std::to_string(axis->rank) : "";
}
} // namespace

TEST(PointColumnName, CoordinatesAsManyProgramsNameThem)
{
  for (const std::string name : { "x",
                                  "X",
                                  " x ",
                                  "centroid_x",
                                  "CenterX",
                                  "BaryCenterX",
                                  "POSITION_X",
                                  "Position X",
                                  "Cell Position X",
                                  "nucleus_center_x",
                                  "pos_x",
                                  "x_pos",
                                  "xCoord",
                                  "x cent",
                                  "X Centroid",
                                  "CX",
                                  "Location_Center_X",
                                  "Nuclei_Location_Center_X" })
  {
    EXPECT_EQ(Parse(name), "x  0") << name;
  }
  for (const std::string name : { "XM",
                                  "center_of_mass_x",
                                  "Center of Mass X",
                                  "CoM x",
                                  "AreaShape_Center_X",
                                  "Center of Homogeneous Mass X",
                                  "Center of Image Mass X" })
  {
    EXPECT_EQ(Parse(name), "x  1") << name;
  }
  EXPECT_EQ(Parse("Center of the object_0"), "x voxels 0");
  EXPECT_EQ(Parse("Center of the object_2"), "z voxels 0");
  EXPECT_TRUE(ParseAxisName("Location_Center_Y")->isMostlyInVoxels);
  EXPECT_FALSE(ParseAxisName("Center_Y")->isMostlyInVoxels);
}

TEST(PointColumnName, UnitsInAnyWriting)
{
  for (const std::string name : { "z_um",
                                  "Z (microns)",
                                  "Centroid Z \xC2\xB5m",
                                  "Z [\xCE\xBCm]",
                                  "Z, \xC2\xB5m",
                                  "z (\xC3\x82\xC2\xB5m)",
                                  "z.um",
                                  "z/um",
                                  "z in um",
                                  "z (micrometers)",
                                  "z_micron" })
  {
    EXPECT_EQ(Parse(name), "z um 0") << name;
  }
  EXPECT_EQ(Parse("z_nm"), "z nm 0");
  EXPECT_EQ(Parse("z [mm]"), "z mm 0");
  EXPECT_EQ(Parse("z (meters)"), "z m 0");
  EXPECT_EQ(Parse("CZ (unit)"), "z units 0");
  for (const std::string name : { "z_px", "CZ (pix)", "z [voxels]", "z (pixel)", "z_vx" })
  {
    EXPECT_EQ(Parse(name), "z voxels 0") << name;
  }
  EXPECT_EQ(ParseUnit("(micron)"), "um");
  EXPECT_EQ(ParseUnit("[px]"), "voxels");
  EXPECT_FALSE(ParseUnit("(sec)"));
  EXPECT_FALSE(ParseUnit(""));
}

TEST(PointColumnName, ColumnsOfOneStemBelongTogether)
{
  EXPECT_EQ(ParseAxisName("CX (unit)")->stem, ParseAxisName("CZ (unit)")->stem);
  EXPECT_EQ(ParseAxisName("x_um")->stem, ParseAxisName("Y_um")->stem);
  EXPECT_NE(ParseAxisName("CX (unit)")->stem, ParseAxisName("CZ (pix)")->stem);
  EXPECT_NE(ParseAxisName("x")->stem, ParseAxisName("y_um")->stem);
}

TEST(PointColumnName, OtherNamesAreNoCoordinates)
{
  for (const std::string name : { "",
                                  "x_error",
                                  "std_x",
                                  "min_x",
                                  "velocity_x",
                                  "bbox_x",
                                  "label_x",
                                  "area_x",
                                  "x0",
                                  "index",
                                  "box",
                                  "Position Reference Frame X",
                                  "centroid-0" })
  {
    EXPECT_EQ(Parse(name), "") << name;
  }
  EXPECT_EQ(Parse(std::string(100000, ' ') + "x"), "");
}

TEST(PointColumnName, AxesOfAnArrayLabelsAndTimes)
{
  EXPECT_EQ(ParseNumberedAxis("axis-2"), 2);
  EXPECT_EQ(ParseNumberedAxis("weighted_centroid-0"), 0);
  EXPECT_EQ(ParseNumberedAxis("Centroid_1"), 1);
  EXPECT_FALSE(ParseNumberedAxis("axis"));
  EXPECT_EQ(RankLabelName("LABEL"), 0);
  EXPECT_EQ(RankLabelName("ObjectNumber"), 1);
  EXPECT_EQ(RankLabelName("labelimage_oid"), 1);
  EXPECT_FALSE(RankLabelName("label name"));
  for (const std::string name :
       { "FRAME", "frame", "timepoint", "Time point", "timestep", "Spot frame", "t index", "tp", "Metadata_Timepoint" })
  {
    EXPECT_EQ(RankFrameName(name), 0) << name;
  }
  for (const std::string name :
       { "t", "Time", "POSITION_T", "Time [s]", "time_min", "t (sec)", "Metadata_T", "Slice_T", "hpf" })
  {
    EXPECT_EQ(RankFrameName(name), 1) << name;
  }
  EXPECT_EQ(RankFrameName("ImageNumber"), 2);
  EXPECT_FALSE(RankFrameName("temperature"));
  EXPECT_EQ(QuoteName(std::string(61, 'a')), "'" + std::string(60, 'a') + "...'");
  EXPECT_EQ(QuoteName(std::string(59, 'a') + "\xC2\xB5"), "'" + std::string(59, 'a') + "...'");
}
