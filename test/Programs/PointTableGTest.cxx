/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointTable.h"

#include "RefusalOf.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace tissue;

namespace
{
using Texts = std::vector<std::string>;

const std::vector<Point> expected{ { { 1.125, 2.5, 3.0 } }, { { 4.25, 5.75, 6.5 } }, { { 7.0, 8.5, 9.875 } } };

PointFile
Read(const std::string & text, const PointFileOptions & options = PointFileOptions())
{
  std::istringstream stream(text);
  return ReadPointTable(stream, options);
}

std::string
Refusal(const std::string & text, const PointFileOptions & options = PointFileOptions())
{
  return RefusalOf([&] { Read(text, options); });
}

PointFileOptions
ByColumns(const Texts & columns, std::size_t firstLine = 0)
{
  PointFileOptions options;
  options.columns = columns;
  options.firstLine = firstLine;
  return options;
}

PointFileOptions
OfFrame(const std::string & frame)
{
  PointFileOptions options;
  options.frame = frame;
  return options;
}
} // namespace

TEST(PointTable, LinesOfNamesAndUnitsAboveAndBelowBelongTogether)
{
  // TrackMate 7.
  const auto trackMate = Read("LABEL,ID,POSITION_X,POSITION_Y,POSITION_Z,FRAME\nLabel,Spot ID,X,Y,Z,Frame\n"
                              "Label,Spot ID,X,Y,Z,Frame\n,,(micron),(micron),(micron),\n"
                              "ID6,6,1.125,2.5,3,0\nID7,7,4.25,5.75,6.5,0\nID8,8,7,8.5,9.875,0\n");
  EXPECT_EQ(trackMate.points, expected);
  EXPECT_EQ(trackMate.unit, "um");
  EXPECT_EQ(trackMate.names, (Texts{ "ID6", "ID7", "ID8" }));
  EXPECT_TRUE(trackMate.labels.empty());
  EXPECT_EQ(trackMate.places[0], "line 5");
  // Mastodon.
  const auto mastodon =
    Read("Label,ID,Spot frame,Spot position,Spot position,Spot position\n,,,X,Y,Z\n,,,(um),(um),(um)\n"
         "0,0,0,1.125,2.5,3\n1,1,0,4.25,5.75,6.5\n2,2,0,7,8.5,9.875\n");
  EXPECT_EQ(mastodon.points, expected);
  EXPECT_EQ(mastodon.unit, "um");
  EXPECT_EQ(mastodon.labels, (std::vector<Label>{ 0, 1, 2 }));
  // Imaris.
  const auto imaris =
    Read("\n Cell Position \n ==================== \nCell Position X,Cell Position Y,Cell Position Z,Unit,"
         "Category,Time,ID,\n1.125,2.5,3,mm,Cell,1,0,\n4.25,5.75,6.5,mm,Cell,1,1,\n7,8.5,9.875,mm,Cell,"
         "1,2,\n");
  EXPECT_EQ(imaris.points, expected);
  EXPECT_EQ(imaris.unit, "mm");
  EXPECT_TRUE(imaris.warnings.empty());
  EXPECT_EQ(Read("Date;2020\nx;y;z\n1;2;3\n").warnings,
            (Texts{ "line 1 before the names of the columns (line 2) left out" }));
  // TrackMate of an image without a voxel size.
  EXPECT_EQ(Refusal("POSITION_X,POSITION_Y,POSITION_Z\n(pixel),(pixel),(pixel)\n1,2,3\n"),
            "line 1: the column 'POSITION_X (pixel)' is in voxels: --pointSpacing X Y Z gives their size");
  EXPECT_EQ(Refusal("x,y,z\nNA,NA,NA\n1,2,3\n"), "line 2: 'NA' in column 1 ('x') is no number");
}

TEST(PointTable, EdgesAndTracksOfTrackMateAreNoPoints)
{
  const std::string edges = "SPOT_SOURCE_ID,EDGE_X_LOCATION,EDGE_Y_LOCATION,EDGE_Z_LOCATION\nSource,X,Y,Z\n"
                            "7,1.125,2.5,3\n8,4.25,5.75,6.5\n9,7,8.5,9.875\n";
  EXPECT_EQ(Refusal(edges),
            "line 1: the column 'SPOT_SOURCE_ID' is of TrackMate's table of edges, the points are in that of spots; "
            "--columns X Y Z takes others all the same");
  EXPECT_EQ(Read(edges, ByColumns({ "2", "3", "4" }, 3)).points, expected);
  EXPECT_EQ(Refusal("LABEL,TRACK_X_LOCATION,TRACK_Y_LOCATION,TRACK_Z_LOCATION\nLabel,X,Y,Z\na,1,2,3\n").substr(0, 64),
            "line 1: the column 'TRACK_X_LOCATION' is of TrackMate's table of");
}

TEST(PointTable, NamesInComments)
{
  EXPECT_EQ(Read("# z y x\n3 2.5 1.125\n6.5 5.75 4.25\n9.875 8.5 7\n").points, expected);
  EXPECT_EQ(Read("##x,y,z,radius\n1.125,2.5,3,0\n4.25,5.75,6.5,0\n7,8.5,9.875,0\n").points, expected);
  EXPECT_EQ(Read("#,X,Y,Z\n1,1.125,2.5,3\n2,4.25,5.75,6.5\n3,7,8.5,9.875\n").points, expected);
  EXPECT_EQ(Read("% Model: a\n% X  Y   Z\n 1.125  2.5 3\n4.25   5.75 6.5\n7 8.5 9.875\n").points, expected);
}

TEST(PointTable, DecimalSigns)
{
  EXPECT_EQ(Read("x;y;z\n1,125;2,5;3\n4,25;5,75;6,5\n7;8,5;9,875\n").points, expected);
  EXPECT_EQ(Read("x\ty\tz\n1,125\t2,500\t3,000\n4,250\t5,750\t6,500\n7,000\t8,500\t9,875\n").points, expected);
  EXPECT_EQ(Read("x,y,z\n\"1,125\",\"2,5\",3\n\"4,25\",\"5,75\",\"6,5\"\n7,\"8,5\",\"9,875\"\n").points, expected);
  EXPECT_EQ(Read("sep=;\nx;y;z\n1,125;2,5;3\n4,25;5,75;6,5\n7;8,5;9,875\n").points, expected);
  EXPECT_EQ(Refusal("x;y;z\n1,5;2;3\n1.5;2;3\n"),
            "line 2: '1,5' in column 1 ('x') has a decimal comma where others have a decimal point");
  EXPECT_EQ(Refusal("x;y;z\n12;2;3\n1,234;2;3\n"),
            "line 3: '1,234' in column 1 ('x') may have a decimal comma or one of thousands, as others have none");
  for (const std::string number : { "1,234.5", "1.234,5", "1,234,567" })
  {
    EXPECT_EQ(Refusal("x;y;z\n" + number + ";2;3\n"),
              "line 2: '" + number + "' in column 1 ('x') has separators of thousands, which are not read");
  }
  EXPECT_EQ(Refusal("x,y,z\n1,5,2,5,3,5\n"),
            "line 2: there are 6 values, but 3 names, in line 1 (decimal commas must be quoted between commas)");
}

TEST(PointTable, RowsHaveAsManyValuesAsNames)
{
  const std::string shifted = "each row has a value more than there are names (line 1): the first one is taken for the "
                              "name of the row";
  const auto        numbered = Read("\"x\" \"y\" \"z\"\n\"5\" 1.125 2.5 3\n\"6\" 4.25 5.75 6.5\n\"9\" 7 8.5 9.875\n");
  EXPECT_EQ(numbered.points, expected);
  EXPECT_EQ(numbered.labels, (std::vector<Label>{ 5, 6, 9 }));
  EXPECT_EQ(numbered.warnings, (Texts{ shifted }));
  const auto named = Read("x,y,z\ncell a,1.125,2.5,3\ncell b,4.25,5.75,6.5\ncell c,7,8.5,9.875\n");
  EXPECT_EQ(named.points, expected);
  EXPECT_EQ(named.names, (Texts{ "cell a", "cell b", "cell c" }));
  EXPECT_EQ(Refusal("x,y,z\n1.5,2,3,4\n2.5,2,3,4\n").substr(0, 41), "line 2: there are 4 values, but 3 names, ");
  EXPECT_EQ(Refusal("name,x,y,z\n1.5,2,3\n2.5,2,3\n"), "line 2: there are 3 values, but 4 names, in line 1");
  EXPECT_EQ(Refusal("x,y,z\n1,2,3\n1,2\n"), "line 3: there are 2 values, but 3 names, in line 1");
  EXPECT_EQ(Refusal("1,2,3\n1,2\n"), "line 2: there are 2 values, but 3 in line 1");
  // Separators at the end of a line are no values.
  EXPECT_EQ(Read("x,y,z\n1,2,3,\n4,5,6,\n").points[1], (Point{ { 4, 5, 6 } }));
  EXPECT_EQ(Read("x,y,z,\n1,2,3\n4,5,6,\n").points[1], (Point{ { 4, 5, 6 } }));
  EXPECT_EQ(Refusal("x,y,z\n1,2,3\nx,y,z\n1,2,3\n"),
            "line 3: 'x' in column 1 ('x') again: is there a second table in the file?");
}

TEST(PointTable, ColumnsWithoutNamesByTheirNumbers)
{
  const std::string rows = "1;1.125;2.5;3.0;1\n2;4.25;5.75;6.5;1\n3;7.0;8.5;9.875;1\n";
  EXPECT_EQ(Read(rows, ByColumns({ "2", "3", "4" })).points, expected);
  EXPECT_EQ(
    Refusal(rows),
    "line 1: there are 5 columns and no line of their names before, which only three, x, y and z, can do without: "
    "--columns X Y Z says their numbers, from 1 on");
  // Values that are the numbers, too.
  EXPECT_EQ(Read("a,b,c\n1,2,3\n", ByColumns({ "3", "2", "1" })).points, (std::vector<Point>{ { { 3, 2, 1 } } }));
  EXPECT_EQ(Read("Date;2020\nn;x;y;z\n1;2;3;4\n", ByColumns({ "4", "3", "2" })).points,
            (std::vector<Point>{ { { 4, 3, 2 } } }));
  // Lines of a header without names of columns.
  const std::string four = rows + "4;1.5;1.5;1.5;1\n";
  const auto        read = Read("video;0.5;0.5;4;60\n1;0;0;0;0\n" + four, ByColumns({ "2", "3", "4" }));
  EXPECT_EQ(read.points.size(), 4u);
  EXPECT_EQ(read.points[0], expected[0]);
  EXPECT_EQ(read.warnings,
            (Texts{ "lines 1 and 2 left out, being unlike all others: --firstLine says the line of the first point" }));
  EXPECT_EQ(Refusal("1;0;0;0;0\n" + four, ByColumns({ "2", "3", "4" })),
            "line 1 alone has whole numbers: is it a point (--firstLine 1) or none (--firstLine 2)?");
  EXPECT_EQ(Read("1;0;0;0;0\n" + four, ByColumns({ "2", "3", "4" }, 1)).points.size(), 5u);
  EXPECT_EQ(Read("1;0;0;0;0\n" + four, ByColumns({ "2", "3", "4" }, 2)).points.size(), 4u);
  EXPECT_EQ(Refusal(four, ByColumns({}, 9)), "there is nothing from line 9 on (--firstLine)");
  EXPECT_EQ(Refusal("0,1,2\n1,2,3\n"),
            "line 1 may count the columns: is it a point (--firstLine 1) or none (--firstLine 2)?");
  EXPECT_EQ(Read("axis-0,axis-1,axis-2\n3,2,1\n", ByColumns({ "axis-2", "axis-1", "axis-0" })).points[0],
            (Point{ { 1, 2, 3 } }));
}

TEST(PointTable, LongOnesWithoutNamesLoseNothing)
{
  std::string rows;
  for (int i = 0; i < 1500; ++i)
  {
    rows += std::to_string(i) + ".5,2.5,3.5\n";
  }
  EXPECT_EQ(Read(rows).points.size(), 1500u);
  EXPECT_EQ(Read(rows, ByColumns({ "3", "2", "1" })).points.size(), 1500u);
}

TEST(PointTable, OneTimePointOfSeveral)
{
  const std::string table = "FRAME,x,y,z,POSITION_T\n0,1,2,3,0\n0,4,5,6,0.0\n2,7,8,9,1.5\n";
  EXPECT_EQ(Refusal(table), "'FRAME' has 2 values: 0, 2; --frame takes the points of one of them, or of all");
  EXPECT_EQ(Read(table, OfFrame("0")).points.size(), 2u);
  EXPECT_EQ(Read(table, OfFrame("2.0")).points, (std::vector<Point>{ { { 7, 8, 9 } } }));
  EXPECT_EQ(Read(table, OfFrame("all")).points.size(), 3u);
  EXPECT_EQ(Refusal(table, OfFrame("1")), "--frame 1 is not there; 'FRAME' has 2 values: 0, 2");
  EXPECT_EQ(Refusal("x,y,z,t\n1,2,3,5\n", OfFrame("6")), "--frame 6 is not there; 't' has 1 value: 5");
  EXPECT_EQ(Read("x,y,z,t\n1,2,3,5\n4,5,6,5.0\n").points.size(), 2u);
  EXPECT_EQ(Refusal("x,y,z\n1,2,3\n", OfFrame("0")).substr(0, 47), "line 1: there is no column of time points (t, t");
  EXPECT_NE(Refusal("ImageNumber,x,y,z\n1,1,2,3\n2,1,2,3\n"), "");
}

TEST(PointTable, LabelsAreNumbersFromZeroOrNames)
{
  EXPECT_EQ(Read("label,x,y,z\n36028797018963969,1,2,3\n7.0,1,2,3\n").labels,
            (std::vector<Label>{ 36028797018963969, 7 }));
  const auto names = Read("label,x,y,z\ncell 12,1,2,3\n7,1,2,3\n");
  EXPECT_EQ(names.names, (Texts{ "cell 12", "7" }));
  EXPECT_EQ(names.warnings.size(), 1u);
  for (const std::string label : { "-1", "1.5", "1e300", "nan" })
  {
    EXPECT_EQ(Refusal("label,x,y,z\n" + label + ",1,2,3\n"),
              "line 2: '" + label + "' in column 1 ('label') is no whole number from 0 on");
  }
}

TEST(PointTable, SummariesAndMeans)
{
  const auto read = Read("name,x,y,z\na,1,2,3\nb,4,5,6\nMean,2.5,3.5,4.5\nSD,1,1,1\n");
  EXPECT_EQ(read.points.size(), 2u);
  EXPECT_EQ(read.warnings, (Texts{ "lines 4 and 5 left out: a summary ('Mean', 'SD')" }));
  std::string rows = "x,y,z\n";
  for (int i = 0; i < 8; ++i)
  {
    rows += std::to_string(i * i) + "," + std::to_string(i) + "," + std::to_string(i % 3) + "\n";
  }
  EXPECT_TRUE(Read(rows).warnings.empty());
  EXPECT_EQ(Read(rows + "17.5,3.5,0.875\n").warnings,
            (Texts{ "line 10 is the mean of all points before: is it a row of summary?" }));
}

TEST(PointTable, NothingAtAll)
{
  EXPECT_TRUE(Read("").points.empty());
  EXPECT_TRUE(Read("x,y,z\n").points.empty());
  EXPECT_EQ(Refusal("x,y,z,Unit\n1,2,3,um\n1,2,3,mm\n"), "the rows are of different units: 'um', 'mm'");
}
