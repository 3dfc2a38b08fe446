/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// The program for points, of tables as other programs write them.
#include "TissueTessellationProgramTest.h"

#include <fstream>

namespace
{
class NucleiTessellationTables : public TissueTessellationAppTest
{
protected:
  NucleiTessellationTables() { m_Program = NUCLEI_TESSELLATION_PROGRAM; }

  void
  Write(const std::string & name, const std::string & text) const
  {
    std::ofstream(this->PathOf(name), std::ios::binary) << text;
  }
};
} // namespace

TEST_F(NucleiTessellationTables, NamesOfCellsAreInStatisticsAndReport)
{
  this->Write("t.tsv",
              "LABEL\tPOSITION_X\tPOSITION_Y\tPOSITION_Z\n\t(micron)\t(micron)\t(micron)\nID7\t0\t0\t0\n"
              "a,b\t10\t0\t0\nID9\t0\t10\t0\nID3\t0\t0\t10\n");
  const auto report = this->RunAndReport("t.tsv walls.vtp --refinement 0 --statistics s.csv --cellSurfaces c.vtp");
  EXPECT_EQ(report["input"]["pointUnit"], "um");
  EXPECT_EQ(report["input"]["names"],
            (nlohmann::json{ { "1", "ID7" }, { "2", "a,b" }, { "3", "ID9" }, { "4", "ID3" } }));
  EXPECT_NE(m_Output.find("4 points in um; "), std::string::npos) << m_Output;
  EXPECT_NE(m_Errors.find("warning: the labels are names ('ID7', ...): the cells are numbered from 1 on"),
            std::string::npos)
    << m_Errors;
  this->WriteTissue<unsigned char>("tissue.mha");
  this->ExpectRefusal("t.tsv walls.vtp --evaluateAgainst tissue.mha --evaluateByLabel",
                      { "t.tsv: --evaluateByLabel needs labels that are numbers" });
  const std::string statistics = ReadBytes(this->PathOf("s.csv"));
  EXPECT_NE(statistics.find(",Name\n1,"), std::string::npos) << statistics;
  EXPECT_NE(statistics.find(",ID7\n2,"), std::string::npos) << statistics;
  EXPECT_NE(statistics.find(",\"a,b\"\n3,"), std::string::npos) << statistics;
  EXPECT_NE(ReadBytes(this->PathOf("c.vtp")).find("Name=\"Name\""), std::string::npos);
}

TEST_F(NucleiTessellationTables, ALabelOfZeroIsACell)
{
  this->Write("t.csv", "label,x,y,z\n0,0,0,0\n1,10,0,0\n2,0,10,0\n3,0,0,10\n");
  const auto report = this->RunAndReport("t.csv walls.vtp --refinement 0 --statistics s.csv");
  EXPECT_EQ(report["input"]["exteriorLabel"], -1);
  EXPECT_EQ(report["input"]["cells"], 4);
  EXPECT_TRUE(report["input"]["names"].is_null());
  EXPECT_EQ(report["warnings"][0], "the label 0 is that of a cell: the exterior has the label -1");
  EXPECT_NE(ReadBytes(this->PathOf("s.csv")).find("\n0,"), std::string::npos);
}

TEST_F(NucleiTessellationTables, OptionsChooseColumnsTimeAndScale)
{
  const std::string rows = "0,0,0,0\n0,10,0,0\n0,0,10,0\n0,0,0,10\n1,90,0,0\n1,0,90,0\n1,0,0,90\n1,0,0,0\n";
  this->Write("t.csv", "t,a,b,c\n" + rows);
  const std::string columns = "t.csv walls.vtp --refinement 0 --columns b a 4";
  this->ExpectRefusal("t.csv walls.vtp", { "t.csv: line 1: there is no column x among 't', 'a'", "--columns X Y Z" });
  this->ExpectRefusal(columns, { "t.csv: 't' has 2 values: 0, 1; --frame" });
  const auto report = this->RunAndReport(columns + " --frame 0 --pointSpacing 2 2 2");
  EXPECT_EQ(report["input"]["cells"], 4);
  EXPECT_EQ(report["options"]["columns"], (nlohmann::json{ "b", "a", "4" }));
  EXPECT_EQ(report["options"]["frame"], "0");
  EXPECT_EQ(report["options"]["pointSpacing"], (nlohmann::json{ 2.0, 2.0, 2.0 }));
  this->ExpectRefusal(columns + " --pointSpacing 0 1 1", { "--pointSpacing: 0 is out of range" });
  this->ExpectRefusal("t.csv walls.vtp --columns a b", { "--columns" });
  this->ExpectRefusal("t.csv walls.vtp --firstLine 0", { "--firstLine: 0 is out of range" });
  this->ExpectRefusal("t.csv walls.vtp --firstLine 20", { "t.csv: there is nothing from line 20 on" });
}

TEST_F(NucleiTessellationTables, FilesThatAreNoTablesAreNamedSo)
{
  this->Write("t.xlsx", "PK");
  this->ExpectRefusal("t.xlsx walls.vtp",
                      { "t.xlsx: neither an image in a format that ITK reads nor a file of points" });
  this->Write("t.ply", "ply\n");
  this->ExpectRefusal("t.ply walls.vtp", { "t.ply: is cut off" });
  this->ExpectRefusal("t.ply walls.vtp --frame 1", { "t.ply: --columns, --frame and --firstLine are for tables" });
  this->WriteTissue<unsigned char>("tissue.mha");
  this->ExpectRefusal("tissue.mha walls.vtp --pointSpacing 1 1 1", { "--pointSpacing are for files of points" });
}
