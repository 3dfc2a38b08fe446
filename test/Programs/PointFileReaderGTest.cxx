/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/VTKFiles.h"
#include "Shared/Points/PointFileReader.h"
#include "Shared/Points/PointFileWriter.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <clocale>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <locale>
#include <regex>
#include <stdexcept>

using namespace tissue;

namespace
{
/** Numbers with a comma. */
struct CommaPoint : std::numpunct<char>
{
protected:
  char
  do_decimal_point() const override
  {
    return ',';
  }
};

/** While it lives, numbers are read and written with a comma, by C++ and, where such a locale is, by C. */
class CommaLocale
{
public:
  explicit CommaLocale(const std::string & folder)
    : m_Before(std::locale::global(std::locale(std::locale::classic(), new CommaPoint)))
  {
    const std::string make = "localedef -i de_DE -f UTF-8 " + folder + "/de_DE.UTF-8 > /dev/null 2>&1";
    if (std::setlocale(LC_NUMERIC, "de_DE.UTF-8") == nullptr && std::system(make.c_str()) == 0)
    {
      setenv("LOCPATH", folder.c_str(), 1);
      std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
      unsetenv("LOCPATH");
    }
  }
  CommaLocale(const CommaLocale &) = delete;
  CommaLocale &
  operator=(const CommaLocale &) = delete;
  ~CommaLocale()
  {
    std::setlocale(LC_NUMERIC, "C");
    std::locale::global(m_Before);
  }

private:
  std::locale m_Before;
};

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
  table.points = { { { 1.25, -2.5, 1e-7 } }, { { 0.1, 12345.678901234, 1.0 / 3.0 } } };
  table.columns = { { "Label", { 7.0, 9.0 } }, { "scale", { 0.3, 1.0 / 3.0 } } };
  for (const std::string format : { ".csv", ".fcsv", ".vtp" })
  {
    const std::string path = PathOf("points" + format);
    EXPECT_EQ(RequirePointFormat(path), format);
    WritePoints(table, path, format);
    const tissue::PointFile read = ReadPointFile(path);
    ASSERT_EQ(read.points.size(), 2u) << format;
    for (std::size_t i = 0; i < 2; ++i)
    {
      EXPECT_EQ(read.points[i], table.points[i]) << format;
    }
    if (format == ".csv")
    {
      EXPECT_EQ(read.labels, (std::vector<Label>{ 7, 9 }));
    }
  }
}

TEST_F(PointFiles, HaveLabelsInAColumnOfEitherName)
{
  for (const std::string name : { "Label", "label", "LABEL" })
  {
    const tissue::PointFile read = ReadPointFile(Write("a.csv", "x,y,z," + name + "\n1,2,3,8\n"));
    EXPECT_EQ(read.labels, (std::vector<Label>{ 8 })) << name;
  }
}

TEST_F(PointFiles, AreTheSameInALocaleOfDecimalCommas)
{
  PointTable table;
  table.points = { { { 1.5, -2.25, 12345.5 } } };
  table.columns = { { "Label", { 1234.0 } }, { "scale", { 0.5 } } };
  const auto formats = { ".csv", ".fcsv", ".vtp" };
  for (const std::string format : formats)
  {
    WritePoints(table, PathOf("plain" + format), format);
  }
  const CommaLocale locale(m_Folder.string());
  for (const std::string format : formats)
  {
    const std::string plain = PathOf("plain" + format);
    const std::string comma = PathOf("comma" + format);
    WritePoints(table, comma, format);
    EXPECT_EQ(ReadBytes(plain), ReadBytes(comma)) << format;
    EXPECT_EQ(ReadPointFile(plain).points, table.points) << format;
  }
}

TEST_F(PointFiles, CoordinatesByTheNamesOfTheirColumns)
{
  for (const std::string header : { "n,x,y,z",
                                    "n,X,Y,Z",
                                    "i_x,x_um,y_um,z_um",
                                    "Volume,CenterX,CenterY,CenterZ",
                                    "n,centroid_x,centroid_y,centroid_z",
                                    "n,X (microns),Y (microns),Z (microns)",
                                    "n,Position X,Position Y,Position Z",
                                    "n,Centroid X \xC2\xB5m,Centroid Y \xC2\xB5m,Centroid Z \xC2\xB5m",
                                    "XM,\"X [mm]\",\"Y [mm]\",\"Z [mm]\"",
                                    "x_px,x.nm,y.nm,z.nm" })
  {
    const auto file = ReadPointFile(Write("a.csv", header + "\n9, 2.5 ,-3,4\n"));
    ASSERT_EQ(file.points.size(), 1u) << header;
    EXPECT_EQ(file.points[0], (Point{ { 2.5, -3.0, 4.0 } })) << header;
    EXPECT_TRUE(file.labels.empty());
  }
  const auto swapped = ReadPointFile(Write("b.csv", "z,LABEL,y,x\n3,7,2,1\n"));
  EXPECT_EQ(swapped.points[0], (Point{ { 1.0, 2.0, 3.0 } }));
  EXPECT_EQ(swapped.labels, (std::vector<Label>{ 7 }));
}

TEST_F(PointFiles, OfEveryExtensionOfATable)
{
  for (const std::string extension : { ".csv", ".TSV", ".tab", ".txt", ".xls", ".dat", ".xyz", ".marker", ".apo" })
  {
    const std::string path = Write("a" + extension, "x y z\n1 2 3\n");
    EXPECT_TRUE(IsPointFile(path)) << extension;
    EXPECT_EQ(ReadPointFile(path).points, (std::vector<Point>{ { { 1, 2, 3 } } })) << extension;
  }
  EXPECT_FALSE(IsPointFile("a.tif"));
  const std::string ply = Write("a.ply",
                                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                                "property float z\nend_header\n1 2 3\n");
  EXPECT_TRUE(IsPointFile(ply));
  EXPECT_EQ(ReadPointFile(ply).points, (std::vector<Point>{ { { 1, 2, 3 } } }));
}

TEST_F(PointFiles, OptionsSayWhatTheFileDoesNot)
{
  PointFileOptions options;
  options.spacing = { { 0.5, 2.0, 10.0 } };
  const auto scaled = ReadPointFile(Write("a.csv", "x_um,y_um,z_um\n1,2,3\n"), options);
  EXPECT_EQ(scaled.points, (std::vector<Point>{ { { 0.5, 4.0, 30.0 } } }));
  EXPECT_EQ(scaled.unit, "");
  options.columns = { "3", "2", "1" };
  EXPECT_EQ(ReadPointFile(Write("a.csv", "a,b,c\n1,2,3\n"), options).points[0], (Point{ { 1.5, 4.0, 10.0 } }));
  const std::string path = Write("a.fcsv", "# columns = id,x,y,z\n1,2,3,4\n");
  try
  {
    ReadPointFile(path, options);
    ADD_FAILURE();
  }
  catch (const std::runtime_error & error)
  {
    EXPECT_EQ(std::string(error.what()), "--columns, --frame and --firstLine are for tables (.csv, .tsv, .txt, ...)");
  }
}

TEST_F(PointFiles, TextAsOtherToolsWriteIt)
{
  const auto file = ReadPointFile(Write("a.csv",
                                        "\xEF\xBB\xBF\"name\",\"x\",\"y\",\"z\"\r\n\r\n\"a, \"\"b\"\", c\",\"1.5\",2,"
                                        "3\r\n,,,\r\nd,+4,5e1,6\r\n"));
  EXPECT_EQ(file.points, (std::vector<Point>{ { { 1.5, 2, 3 } }, { { 4, 50, 6 } } }));
  EXPECT_EQ(file.places, (std::vector<std::string>{ "line 3", "line 5" }));
  EXPECT_EQ(
    ReadPointFile(Write("b.fcsv", "# CoordinateSystem = 1\r\n# columns = id,x,y,z,label\r\n1,1,2,3,\"a,b\"\r\n"))
      .points[0],
    (Point{ { 1, 2, 3 } }));
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
  EXPECT_EQ(ReadPointFile(Write("e.fcsv", lines("# CoordinateSystem = 1\n"))).points[0], (Point{ { 1, 2, 3 } }));
  // Of the versions before there was a choice.
  EXPECT_EQ(ReadPointFile(Write("f.fcsv", lines(""))).points[0], (Point{ { -1, -2, 3 } }));
  EXPECT_NE(Refusal(Write("d.fcsv", lines("# CoordinateSystem = IJK\n"))).find("line 2: the coordinate system 'IJK'"),
            std::string::npos);
}

TEST_F(PointFiles, MarkupsInJson)
{
  const auto markup = [](const std::string & system, const std::string & points, const std::string & more = "") {
    return "{\"type\": \"Fiducial\", \"coordinateSystem\": \"" + system + "\", \"controlPoints\": [" + points + "]" +
           more + "}";
  };
  const auto point = [](const std::string & position, const std::string & status = "defined") {
    return "{\"label\": \"F-1\", \"position\": " + position + ", \"positionStatus\": \"" + status + "\"}";
  };
  const auto file = [](const std::string & markups) { return "{\"markups\": [" + markups + "]}"; };
  const auto read = ReadPointFile(Write(
    "a.mrk.json",
    file(markup("LPS", point("[1, 2.5, 3]") + "," + point("[4, 5, 6]")) + "," + markup("RAS", point("[1, 2, 3]")))));
  EXPECT_EQ(read.points, (std::vector<Point>{ { { 1, 2.5, 3 } }, { { 4, 5, 6 } }, { { -1, -2, 3 } } }));
  EXPECT_EQ(read.places[1], "markup 1, point 2");
  EXPECT_TRUE(IsPointFile("a.mrk.json"));

  const auto refusal = [&](const std::string & text) { return Refusal(Write("b.mrk.json", text)); };
  EXPECT_EQ(refusal(file(markup("IJK", point("[1, 2, 3]")))),
            "markup 1: the coordinate system 'IJK' is none of LPS, 1, RAS, 0");
  EXPECT_EQ(refusal(file(markup("LPS", point("[1, 2, 3]") + "," + point("[1, \"two\", 3]")))),
            "markup 1, point 2: its position is [1,\"two\",3], must be three finite numbers");
  EXPECT_EQ(refusal(file(markup("LPS", point("[1, 2]")))),
            "markup 1, point 1: its position is [1,2], must be three finite numbers");
  EXPECT_EQ(refusal(file(markup("LPS", point("[0, 0, 0]", "lost")))),
            "markup 1, point 1: its positionStatus is 'lost', must be defined, undefined, preview or missing");
  EXPECT_EQ(refusal(file(markup("LPS", "{\"label\": \"F-1\"}"))),
            "markup 1, point 1 has no list 'position', as markups of 3D Slicer have");
  EXPECT_EQ(refusal(file("{\"type\": \"Curve\", \"controlPoints\": []}")),
            "markup 1 is of the type 'Curve', must be Fiducial: a list of points");
  for (const char * text : { "{}", "[]", "3", "{\"markups\": 3}" })
  {
    EXPECT_EQ(refusal(text), "the file has no list 'markups', as markups of 3D Slicer have") << text;
  }
  EXPECT_NE(refusal("{\"markups\":\n [1,").find("is no JSON: parse error at line 2"), std::string::npos);
  EXPECT_NE(refusal("{\"markups\": [{\"position\": 1e999}]}").find("is no JSON: number overflow"), std::string::npos);
}

TEST_F(PointFiles, MarkupsWithoutAPlaceAreLeftOutWithAWarning)
{
  const auto read =
    ReadPointFile(Write("a.mrk.json",
                        "{\"markups\": [{\"type\": \"Fiducial\", \"coordinateSystem\": \"LPS\", \"controlPoints\": ["
                        "{\"positionStatus\": \"undefined\"}, {\"position\": [1, 2, 3]}, "
                        "{\"position\": [0, 0, 0], \"positionStatus\": \"missing\"}]}]}"));
  EXPECT_EQ(read.points, (std::vector<Point>{ { { 1, 2, 3 } } }));
  EXPECT_EQ(read.places, (std::vector<std::string>{ "markup 1, point 2" }));
  EXPECT_EQ(read.warnings, (std::vector<std::string>{ "markup 1: 2 of 3 points have no place and are left out" }));
}

TEST_F(PointFiles, WrittenMarkupsAreThoseOfSlicersSchema)
{
  PointTable table;
  table.points = { { { 1.0, 1.0 / 3.0, -3.0 } }, { { 4.0, 5.0, 6.0 } } };
  table.columns = { { "Label", { 7.0, 8.0 } }, { "scale", { 1.5, 2.0 } }, { "radius", { 2.25, 3.0 } } };
  WritePoints(table, PathOf("a.mrk.json"), ".json");
  EXPECT_EQ(ReadPointFile(PathOf("a.mrk.json")).points, table.points);
  const auto json = nlohmann::json::parse(ReadBytes(PathOf("a.mrk.json")));
  EXPECT_TRUE(
    std::regex_search(json["@schema"].get<std::string>(), std::regex("markups-schema-v1\\.0\\.[0-9]\\.json#$")));
  ASSERT_EQ(json["markups"].size(), 1u);
  const auto & markup = json["markups"][0];
  EXPECT_EQ(markup["type"], "Fiducial");
  EXPECT_EQ(markup["coordinateSystem"], "LPS");
  const auto & point = markup["controlPoints"][0];
  EXPECT_EQ(point["id"], "1");
  EXPECT_EQ(point["label"], "7");
  EXPECT_EQ(point["description"], "scale 1.5, radius 2.25");
  EXPECT_EQ(point["orientation"].size(), 9u);
  EXPECT_EQ(point["positionStatus"], "defined");
}

TEST_F(PointFiles, PolyDataSaysItsCoordinateSystem)
{
  for (const std::string system : { "", "LPS", "RAS", "IJK" })
  {
    const vtkNew<vtkPoints>      points;
    const vtkNew<vtkPolyData>    data;
    const vtkNew<vtkStringArray> space;
    points->InsertNextPoint(1.0, 2.0, 3.0);
    data->SetPoints(points);
    if (!system.empty())
    {
      space->SetName("SPACE");
      space->InsertNextValue(system);
      data->GetFieldData()->AddArray(space);
    }
    WriteXML(data, PathOf("a.vtp"));
    if (system == "IJK")
    {
      EXPECT_EQ(Refusal(PathOf("a.vtp")), "the coordinate system 'IJK' is none of LPS, 1, RAS, 0");
      continue;
    }
    const double sign = system == "RAS" ? -1.0 : 1.0;
    EXPECT_EQ(ReadPointFile(PathOf("a.vtp")).points[0], (Point{ { sign, sign * 2.0, 3.0 } })) << system;
  }
}

TEST_F(PointFiles, SaysWhatIsWrongAndWhere)
{
  EXPECT_NE(Refusal(Write("a.csv", "x,y\n1,2\n")).find("line 1: there is no column z among 'x', 'y'"),
            std::string::npos);
  EXPECT_EQ(Refusal(Write("b.csv", "x,y,z\n1,2,3\n1,two,3\n")), "line 3: 'two' in column 2 ('y') is no number");
  EXPECT_EQ(Refusal(Write("b.csv", "1,2,3\n1,2,\n")), "line 2: '' in column 3 is no number");
  EXPECT_EQ(Refusal(Write("c.csv", "x,y,z\n1,2\n")), "line 2: there are 2 values, but 3 names, in line 1");
  EXPECT_EQ(Refusal(Write("d.csv", "x,y,z\n1,2,nan\n")), "line 2: 'nan' in column 3 ('z') must be finite");
  EXPECT_EQ(Refusal(Write("d.csv", "x,y,z\n1e999,2,3\n")), "line 2: '1e999' in column 1 ('x') must be finite");
  EXPECT_EQ(Refusal(Write("d.csv", "x,y,z,label\n1,2,3,-4\n")),
            "line 2: '-4' in column 4 ('label') is no whole number from 0 on");
  EXPECT_EQ(Refusal(Write("d.csv", "x,y,z\n1,\"2,3\n")), "line 2: a quote is not closed");
  EXPECT_EQ(Refusal(Write("e.fcsv", "# columns = id,x,y,z\n1,2,3\n")),
            "line 2: there are 3 columns, at least 4 are needed");
  EXPECT_NE(Refusal(Write("e.fcsv", "\n# columns = id,r,a,s\n")).find("line 2: there is no column x"),
            std::string::npos);
  EXPECT_NE(Refusal(PathOf("none.csv")), "");
  EXPECT_NE(Refusal(m_Folder.string()), "");
  EXPECT_NE(Refusal(Write("g.vtp", "no XML")), "");
  PointTable table;
  table.points = { { { 1.0, std::numeric_limits<double>::infinity(), 3.0 } } };
  WritePoints(table, PathOf("h.vtp"), ".vtp");
  EXPECT_EQ(Refusal(PathOf("h.vtp")), "point 0: its y is inf, must be finite");
  EXPECT_THROW(RequirePointFormat("points.xls"), std::runtime_error);
}
