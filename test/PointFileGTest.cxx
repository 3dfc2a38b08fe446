/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "PointFile.h"
#include "PointOutput.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

using namespace tissue;

namespace
{
class PointFiles : public TemporaryFolderTest
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
      ReadPointFile(path);
      return "";
    }
    catch (const std::runtime_error & error)
    {
      return error.what();
    }
  }
};
} // namespace

TEST_F(PointFiles, EveryFormatReadsBackWhatWasWritten)
{
  PointTable table;
  table.points = { { { 1.25, -2.5, 1e-7 } }, { { 0.1, 12345.678, 3.0 } } };
  table.columns = { { "label", { 7.0, 9.0 } }, { "scale", { 0.3, 1.0 / 3.0 } } };
  for (const std::string format : { ".csv", ".fcsv", ".vtp" })
  {
    const std::string path = PathOf("points" + format);
    EXPECT_EQ(RequirePointFormat(path), format);
    WritePoints(table, path, format);
    const tissue::PointFile read = ReadPointFile(path);
    ASSERT_EQ(read.points.size(), 2u) << format;
    for (std::size_t i = 0; i < 2; ++i)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(read.points[i][axis], table.points[i][axis], 1e-6) << format;
      }
    }
    if (format == ".csv")
    {
      EXPECT_EQ(read.labels, (std::vector<Label>{ 7, 9 }));
    }
  }
}

TEST_F(PointFiles, CoordinatesByTheNamesOfTheirColumns)
{
  for (const std::string header :
       { "x,y,z,name", "label,X,Y,Z", "i_x,i_y,i_z,x_um,y_um,z_um", "CenterX,CenterY,CenterZ" })
  {
    const bool              hasLabel = header[0] == 'l';
    const bool              hasIndex = header[0] == 'i';
    const bool              hasName = header.back() == 'e';
    const auto              path = Write("a.csv",
                            header + "\n" +
                              (hasLabel   ? "4,"
                                            : hasIndex ? "9,9,9,"
                                                       : "") +
                              "1, 2.5 ,-3" + (hasName ? ",nucleus" : "") + "\n\n");
    const tissue::PointFile file = ReadPointFile(path);
    ASSERT_EQ(file.points.size(), 1u) << header;
    EXPECT_EQ(file.points[0], (Point{ { 1.0, 2.5, -3.0 } })) << header;
    EXPECT_EQ(file.labels.size(), hasLabel ? 1u : 0u);
  }
}

TEST_F(PointFiles, FiducialsInRasAreTurned)
{
  const auto lines = [](const std::string & system) {
    return "# Markups fiducial file version = 4.11\n" + system +
           "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\nn_1,1,2,3,0,0,0,1,1,1,0,5,,\n";
  };
  EXPECT_EQ(ReadPointFile(Write("a.fcsv", lines("# CoordinateSystem = LPS\n"))).points[0], (Point{ { 1, 2, 3 } }));
  EXPECT_EQ(ReadPointFile(Write("b.fcsv", lines("# CoordinateSystem = RAS\n"))).points[0], (Point{ { -1, -2, 3 } }));
  EXPECT_EQ(ReadPointFile(Write("c.fcsv", lines("# CoordinateSystem = 0\n"))).points[0], (Point{ { -1, -2, 3 } }));
  EXPECT_NE(Refusal(Write("d.fcsv", lines("# CoordinateSystem = IJK\n"))).find("line 2: the coordinate system 'IJK'"),
            std::string::npos);
}

TEST_F(PointFiles, SaysWhatIsWrongAndWhere)
{
  EXPECT_NE(Refusal(Write("a.csv", "x,y\n1,2\n")).find("no column z"), std::string::npos);
  EXPECT_NE(Refusal(Write("b.csv", "x,y,z\n1,2,3\n1,two,3\n")).find("line 3: 'two' in column 2"), std::string::npos);
  EXPECT_NE(Refusal(Write("c.csv", "x,y,z\n1,2\n")).find("line 2 has 2 columns"), std::string::npos);
  EXPECT_NE(Refusal(Write("d.csv", "x,y,z\n1,2,nan\n")).find("line 2"), std::string::npos);
  EXPECT_NE(Refusal(PathOf("none.csv")), "");
  EXPECT_NE(Refusal(Write("g.vtp", "no XML")), "");
  EXPECT_THROW(RequirePointFormat("points.xls"), std::runtime_error);
}
