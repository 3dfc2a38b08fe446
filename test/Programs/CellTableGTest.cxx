/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/CellTable.h"

#include "RefusalOf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace tissue;

namespace
{
CellTable
Read(const std::string & text, const std::string & labelColumn = "")
{
  std::istringstream stream(text);
  return ReadCellTable(stream, labelColumn);
}

std::string
Refusal(const std::string & text, const std::string & labelColumn = "")
{
  return RefusalOf([&] { Read(text, labelColumn); });
}

void
ExpectThreeRates(const CellTable & table)
{
  EXPECT_EQ((std::vector<Label>{ 7, 3, 12 }), table.labels);
  ASSERT_EQ(1u, table.columns.size());
  EXPECT_EQ("rate", table.columns[0].name);
  EXPECT_EQ((std::vector<double>{ 0.5, -2.0, 1000.25 }), table.columns[0].numbers);
}
} // namespace

TEST(CellTable, AreReadAsProgramsWriteThem)
{
  ExpectThreeRates(Read("label,rate\n7,0.5\n3,-2\n12,1000.25\n"));
  ExpectThreeRates(Read("Label;rate\r\n7;0,5\r\n3;-2,0\r\n12;1000,25\r\n"));
  ExpectThreeRates(Read("cell_id\trate\n7.0\t0.5\n3.0\t-2\n12.0\t1.00025e3\n"));
  ExpectThreeRates(Read("\"rate\",\"CellID\"\n\"0,5\",\"7\"\n\"-2,0\",\"3\"\n\"1000,25\",\"12\"\n"));
  ExpectThreeRates(Read("# of one night\n# id rate\n7 0.5\n3 -2\n12 1000.25\n"));
  ExpectThreeRates(Read("\xEF\xBB\xBFid,rate\n,(1/h)\n7,0.5\n3,-2\n12,1000.25\n"));
  // Of R, with a name of each row, and of pandas, with an index.
  ExpectThreeRates(Read("label rate\na 7 0.5\nb 3 -2\nc 12 1000.25\n"));
  const auto ofPandas = Read(",label,rate\n0,7,0.5\n1,3,-2\n2,12,1000.25\n");
  ExpectThreeRates(ofPandas);
  EXPECT_EQ("column 1 has no name and is left out", ofPandas.warnings.at(0));
}

TEST(CellTable, TheLabelColumnIsTheBestOfThoseOfSuchNames)
{
  EXPECT_EQ((std::vector<Label>{ 7 }), Read("id,Label,x\n1,7,2\n").labels);
  EXPECT_EQ((std::vector<Label>{ 1 }), Read("id,tag,x\n1,7,2\n").labels);
  EXPECT_EQ((std::vector<Label>{ 7 }), Read("id,tag,x\n1,7,2\n", "Tag").labels);
  EXPECT_EQ((std::vector<Label>{ 7 }), Read("id,tag,x\n1,7,2\n", "2").labels);
  EXPECT_EQ("id", Read("id,Label,x\n1,7,2\n").columns[0].name);
}

TEST(CellTable, LabelsAndValuesMayBeText)
{
  const CellTable table = Read("cell,fate,x\nn1,sepal,1\nn2,,2\n3,petal,3\n");
  EXPECT_TRUE(table.labels.empty());
  EXPECT_EQ((std::vector<std::string>{ "n1", "n2", "3" }), table.names);
  EXPECT_EQ((std::vector<std::string>{ "sepal", "", "petal" }), table.columns[0].texts);
  EXPECT_TRUE(table.columns[0].numbers.empty());
}

TEST(CellTable, MissingValuesAreNotNumbers)
{
  for (const char * const missing : { "", "NA", "nan", "NaN", "null", "None" })
  {
    const CellTable table = Read(std::string("label,x\n1,2.5\n2,") + missing + "\n");
    EXPECT_EQ(2.5, table.columns[0].numbers[0]);
    EXPECT_TRUE(std::isnan(table.columns[0].numbers[1])) << missing;
  }
}

TEST(CellTable, WhatIsWrongIsSaidByLineAndColumn)
{
  EXPECT_EQ("the table is empty", Refusal(""));
  EXPECT_EQ("the table is empty", Refusal("# nothing\n"));
  EXPECT_EQ("there are no rows below the names of the columns (line 1)", Refusal("label,x\n"));
  EXPECT_EQ("there is no column of labels (label, cell_id, id, ...); line 1 has 'a', 'x'", Refusal("a,x\n1,2\n"));
  EXPECT_EQ("there is no column of labels ('cell'); line 1 has 'label', 'x'", Refusal("label,x\n1,2\n", "cell"));
  EXPECT_EQ("line 1: there are 2 columns, none of number 3", Refusal("label,x\n1,2\n", "3"));
  EXPECT_EQ("line 1: the columns 1 and 3 both are the label ('Label')", Refusal("Label,x,label\n1,2,3\n"));
  EXPECT_EQ("line 1: there is no column of values beside that of the labels ('label')", Refusal("label\n1\n"));
  EXPECT_EQ("line 1: two columns have the name 'x'", Refusal("label,x,x\n1,2,3\n"));
  EXPECT_EQ("line 4: the label '1' is that of line 2, too: a table has one row a cell",
            Refusal("label,x\n1,2\n2,3\n1,4\n"));
  EXPECT_EQ("line 3: 'high' in column 2 ('x') is no number", Refusal("label,x\n1,2.5\n2,high\n"));
  EXPECT_EQ("line 2: 'inf' in column 2 ('x') must be finite", Refusal("label,x\n1,inf\n2,1\n"));
  EXPECT_EQ("line 3: '' in column 1 ('label') is no whole number from 0 on", Refusal("label,x\n1,2\n,3\n"));
  EXPECT_EQ("line 3: '2.5' in column 1 ('label') is no whole number from 0 on", Refusal("label,x\n1,2\n2.5,3\n"));
  EXPECT_NE(std::string::npos, Refusal("label,x,y\n1,2,3\n2,3\n").find("line 3: there are 2 values, but 3 names"));
}
