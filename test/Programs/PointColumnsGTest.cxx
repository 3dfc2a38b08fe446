/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointColumns.h"

#include "RefusalOf.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
using Names = std::vector<std::string>;
using Columns = std::array<std::size_t, 3>;

PointFileOptions
InVoxels()
{
  PointFileOptions options;
  options.spacing = { { 0.5, 0.5, 2.0 } };
  return options;
}

PointFileOptions
ByColumns(const Names & columns)
{
  PointFileOptions options;
  options.columns = columns;
  return options;
}

std::string
Refusal(const Names & names, const PointFileOptions & options = PointFileOptions())
{
  return RefusalOf([&] { FindPointColumns(names, options); });
}
} // namespace

TEST(PointColumns, ThoseWithAUnitAreTakenBeforeOthers)
{
  const Names suite{ "CX (pix)", "CY (pix)", "CZ (pix)", "CX (unit)", "CY (unit)", "CZ (unit)" };
  EXPECT_EQ(FindPointColumns(suite).coordinates, (Columns{ 3, 4, 5 }));
  EXPECT_EQ(FindPointColumns(suite, InVoxels()).coordinates, (Columns{ 0, 1, 2 }));
  const Names both{ "x", "y", "z", "x_um", "y_um", "z_um" };
  EXPECT_EQ(FindPointColumns(both).coordinates, (Columns{ 3, 4, 5 }));
  EXPECT_EQ(FindPointColumns(both).unit, "um");
  EXPECT_EQ(FindPointColumns(both, InVoxels()).coordinates, (Columns{ 0, 1, 2 }));
  EXPECT_EQ(FindPointColumns({ "XM", "YM", "ZM", "X", "Y", "Z" }).coordinates, (Columns{ 3, 4, 5 }));
  EXPECT_EQ(FindPointColumns({ "AreaShape_Center_X",
                               "AreaShape_Center_Y",
                               "AreaShape_Center_Z",
                               "Location_Center_X",
                               "Location_Center_Y",
                               "Location_Center_Z" })
              .coordinates,
            (Columns{ 3, 4, 5 }));
}

TEST(PointColumns, VoxelsNeedTheirSize)
{
  const Names ilastik{ "Center of the object_0", "Center of the object_1", "Center of the object_2" };
  EXPECT_EQ(Refusal(ilastik),
            "the column 'Center of the object_0' is in voxels: --pointSpacing X Y Z gives their size");
  EXPECT_EQ(FindPointColumns(ilastik, InVoxels()).coordinates, (Columns{ 0, 1, 2 }));
  EXPECT_TRUE(FindPointColumns({ "x", "y", "z", "radius", "shape" }).isMostlyInVoxels);
  EXPECT_FALSE(FindPointColumns({ "x", "y", "z", "radius" }).isMostlyInVoxels);
}

TEST(PointColumns, TheOptionNamesOrNumbersThem)
{
  const Names names{ "n", "a", "B", "c_um", "a " };
  EXPECT_EQ(FindPointColumns({ "axis-0", "axis-1", "axis-2" }, ByColumns({ "axis-2", "axis-1", "axis-0" })).coordinates,
            (Columns{ 2, 1, 0 }));
  EXPECT_EQ(FindPointColumns(names, ByColumns({ "2", "b", "N" })).coordinates, (Columns{ 1, 2, 0 }));
  EXPECT_EQ(FindPointColumns({}, ByColumns({ "2", "3", "4" })).coordinates, (Columns{ 1, 2, 3 }));
  EXPECT_EQ(FindPointColumns({ "x", "y", "z", "x" }, ByColumns({ "4", "y", "z" })).coordinates, (Columns{ 3, 1, 2 }));
  EXPECT_EQ(Refusal(names, ByColumns({ "6", "1", "2" })), "there is no column 6 (--columns), there are 5");
  EXPECT_EQ(Refusal(names, ByColumns({ "q", "1", "2" })),
            "there is no column 'q' (--columns) among 'n', 'a', 'B', 'c_um', 'a '");
  EXPECT_EQ(Refusal({ "a", "A", "b" }, ByColumns({ "a", "b", "3" })),
            "two columns are named 'a': --columns takes their numbers, too");
  EXPECT_EQ(Refusal({ "x_um", "y_mm", "z_um" }, ByColumns({ "1", "2", "3" })),
            "the columns 'x_um' and 'y_mm' are of different units");
}

TEST(PointColumns, WhatMayBeMeantOtherwiseIsRefused)
{
  EXPECT_EQ(Refusal({ "x", "X", "y", "z" }), "the columns 'x' and 'X' both are x: --columns X Y Z says which is meant");
  EXPECT_EQ(Refusal({ "x_um", "y_um", "z_um", "x_mm", "y_mm", "z_mm" }),
            "the columns 'x_um' and 'x_mm' both are x: --columns X Y Z says which is meant");
  EXPECT_EQ(Refusal({ "x_um", "y_um", "z_mm", "n" }), "the columns 'x_um' and 'z_mm' are of different units");
  EXPECT_EQ(Refusal({ "x", "y", "label", "z", "Label" }), "the columns 3 and 5 both are the label");
  EXPECT_NE(
    Refusal({ "X", "Y", "Slice" }).find("there is no column z among 'X', 'Y', 'Slice'; accepted are z, center_z"),
    std::string::npos);
  const std::string napari = Refusal({ "index", "axis-0", "axis-1", "axis-2", "axis-3" });
  EXPECT_NE(napari.find("'axis-0' is numbered by the axes of an array, of which the first is mostly z"),
            std::string::npos);
  EXPECT_NE(napari.find("--columns 'axis-3' 'axis-2' 'axis-1'"), std::string::npos);
  EXPECT_NE(
    Refusal({ "Centroid_1", "Centroid_2", "Centroid_3" }).find("--columns 'Centroid_1' 'Centroid_2' 'Centroid_3'"),
    std::string::npos);
}

TEST(PointColumns, LabelsAndTimesByTheLikeliestName)
{
  const auto columns = FindPointColumns({ "x", "y", "z", "POSITION_T", "ObjectNumber", "Label", "FRAME" });
  EXPECT_EQ(columns.label, 5u);
  EXPECT_EQ(columns.frames, (std::vector<std::size_t>{ 6, 3 }));
  EXPECT_EQ(FindPointColumns({ "x", "y", "z", "ObjectNumber" }).label, 3u);
  EXPECT_FALSE(FindPointColumns({ "x", "y", "z" }).label);
}
