/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "PointFile.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

using namespace tissue;

namespace
{
class PointFile : public TemporaryFolderTest
{
protected:
  std::string
  Write(const std::string & name, const std::string & text) const
  {
    std::ofstream(PathOf(name)) << text;
    return PathOf(name);
  }

  /** The message of the error, or nothing. */
  static std::string
  Refusal(const std::string & path)
  {
    try
    {
      ReadPoints(path);
      return "";
    }
    catch (const std::runtime_error & error)
    {
      return error.what();
    }
  }
};
} // namespace

TEST_F(PointFile, EveryFormatReadsBackWhatWasWritten)
{
  PointTable table;
  table.points = { { { 1.25, -2.5, 1e-7 } }, { { 0.1, 12345.678, 3.0 } } };
  table.columns = { { "label", { 7.0, 9.0 } }, { "scale", { 0.3, 1.0 / 3.0 } } };
  for (const std::string format : { ".csv", ".fcsv", ".vtp" })
  {
    const std::string path = PathOf("points" + format);
    EXPECT_EQ(RequirePointFormat(path), format);
    WritePoints(table, path, format);
    const PointTable read = ReadPoints(path);
    ASSERT_EQ(read.points.size(), 2u) << format;
    for (std::size_t i = 0; i < 2; ++i)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(read.points[i][axis], table.points[i][axis], 1e-6) << format;
      }
    }
    ASSERT_NE(read.FindColumn("label"), nullptr) << format;
    EXPECT_EQ(*read.FindColumn("label"), table.columns[0].second);
    EXPECT_EQ(read.FindColumn("none"), nullptr);
    if (format != ".fcsv") // fiducials have no numbers but their place
    {
      ASSERT_NE(read.FindColumn("scale"), nullptr);
      EXPECT_EQ(*read.FindColumn("scale"), table.columns[1].second);
    }
  }
}

TEST_F(PointFile, CoordinatesByTheNamesOfTheirColumns)
{
  for (const std::string header : { "x,y,z,name",
                                    "label,X,Y,Z",
                                    "i_x,i_y,i_z,x_um,y_um,z_um",
                                    "CenterX,CenterY,CenterZ",
                                    "centroid_x,centroid_y,centroid_z" })
  {
    const bool hasLabel = header[0] == 'l';
    const bool hasIndex = header[0] == 'i';
    const bool hasName = header.back() == 'e';
    const auto path = Write("a.csv",
                            header + "\n" +
                              (hasLabel   ? "4,"
                               : hasIndex ? "9,9,9,"
                                          : "") +
                              "1, 2.5 ,\"-3\"" + (hasName ? ",nucleus" : "") + "\n\n");
    const auto table = ReadPoints(path);
    ASSERT_EQ(table.points.size(), 1u) << header;
    EXPECT_EQ(table.points[0], (Point{ { 1.0, 2.5, -3.0 } })) << header;
    EXPECT_EQ(table.FindColumn("label") != nullptr, hasLabel);
    EXPECT_EQ(table.FindColumn("name"), nullptr); // text
  }
}

TEST_F(PointFile, FiducialsInRasAreTurned)
{
  const auto lines = [](const std::string & system) {
    return "# Markups fiducial file version = 4.11\n" + system +
           "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\nn_1,1,2,3,0,0,0,1,1,1,0,5,,\n";
  };
  EXPECT_EQ(ReadPoints(Write("a.fcsv", lines("# CoordinateSystem = LPS\n"))).points[0], (Point{ { 1, 2, 3 } }));
  EXPECT_EQ(ReadPoints(Write("b.fcsv", lines("# CoordinateSystem = RAS\n"))).points[0], (Point{ { -1, -2, 3 } }));
  EXPECT_EQ(ReadPoints(Write("c.fcsv", lines("# CoordinateSystem = 0\n"))).points[0], (Point{ { -1, -2, 3 } }));
  EXPECT_NE(Refusal(Write("d.fcsv", lines("# CoordinateSystem = IJK\n"))).find("'IJK' in line 2"), std::string::npos);
}

TEST_F(PointFile, SaysWhatIsWrongAndWhere)
{
  EXPECT_NE(Refusal(Write("a.csv", "x,y\n1,2\n")).find("no columns x, y and z"), std::string::npos);
  EXPECT_NE(Refusal(Write("b.csv", "x,y,z\n1,2,3\n1,two,3\n")).find("'two' in line 3, column y"), std::string::npos);
  EXPECT_NE(Refusal(Write("c.csv", "x,y,z\n1,2\n")).find("line 2 has 2 columns"), std::string::npos);
  EXPECT_NE(Refusal(Write("d.csv", "x,y,z\n1,2,nan\n")).find("'nan' in line 2"), std::string::npos);
  EXPECT_NE(Refusal(Write("e.csv", "")).find("empty"), std::string::npos);
  EXPECT_NE(Refusal(PathOf("none.csv")).find("no such file"), std::string::npos);
  EXPECT_NE(Refusal(Write("f.txt", "x,y,z\n")).find(".csv, .fcsv and .vtp"), std::string::npos);
  EXPECT_NE(Refusal(Write("g.vtp", "no XML")).find("no vtkPolyData"), std::string::npos);
  EXPECT_THROW(RequirePointFormat("points.xls"), std::runtime_error);
}
