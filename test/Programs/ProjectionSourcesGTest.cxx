/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Projection/ProjectionSources.h"

#include "RefusalOf.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
using ProjectionOptionsTest = TemporaryFolderTest;

/** The exterior and cells of the labels 2, 5 and 7. */
const std::vector<Cell> &
ThreeCells()
{
  static const std::vector<Cell> cells = [] {
    std::vector<Cell> made(4);
    made[1].label = 2;
    made[2].label = 5;
    made[3].label = 7;
    return made;
  }();
  return cells;
}

std::vector<SignalSource>
ParseSignals(const std::vector<std::string> & signals, const std::vector<unsigned int> & channels = {})
{
  ProjectionOptions options;
  options.signals = signals;
  options.channels = channels;
  return ListSignals(options);
}
} // namespace

TEST_F(ProjectionOptionsTest, SignalsAreCalledAsTheirFilesOrAsAsked)
{
  const auto signals =
    ParseSignals({ "a/dr5.mha", "b.nii.gz", "c.ome.tif", "d.h5:/exported/pin1", "e.v2.nrrd", "VENUS=f.mha" }, { 2 });
  const std::vector<std::string> names{ "dr5", "b", "c", "pin1", "e.v2", "VENUS" };
  ASSERT_EQ(names.size(), signals.size());
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    EXPECT_EQ(names[i], signals[i].name);
    EXPECT_EQ(2u, signals[i].image.channel);
  }
  EXPECT_EQ("f.mha", signals.back().file);
  WriteLines("k=1.mha", "");
  EXPECT_EQ("k=1", ParseSignals({ this->PathOf("k=1.mha") })[0].name);
}

TEST_F(ProjectionOptionsTest, EachSignalMayHaveAChannelOfItsOwn)
{
  const auto signals = ParseSignals({ "r=a.tif", "g=a.tif" }, { 1, 3 });
  EXPECT_EQ(1u, signals[0].image.channel);
  EXPECT_EQ(3u, signals[1].image.channel);
  EXPECT_NE(std::string::npos, RefusalOf([] {
                                 ParseSignals({ "a", "b" }, { 1, 2, 3 });
                               }).find("--signalChannel has 3 values"));
  EXPECT_NE(std::string::npos, RefusalOf([] { ParseSignals({ "=a" }); }).find("has no name"));
  EXPECT_NE(std::string::npos, RefusalOf([] { ParseSignals({ "a=" }); }).find("has no file"));
}

TEST(ProjectionSources, RowsAreThoseOfTheLabels)
{
  CellTable table;
  table.labels = { 7, 9, 2 };
  table.names = { "7", "9", "2" };
  const MatchedRows rows = MatchRows(table, ThreeCells(), {});
  EXPECT_EQ((std::vector<std::ptrdiff_t>{ -1, 2, -1, 0 }), rows.rowOfVertex);
  EXPECT_EQ((std::vector<std::string>{ "9" }), rows.unknownLabels);
  EXPECT_EQ((std::vector<Label>{ 5 }), rows.cellsWithoutRow);
}

TEST(ProjectionSources, RowsAreThoseOfTheNamesWhereTheCellsHaveSome)
{
  CellTable table;
  table.names = { "b", "x", "a" };
  const std::map<Label, std::string> names{ { 2, "a" }, { 5, "b" }, { 7, "c" } };
  EXPECT_EQ((std::vector<std::ptrdiff_t>{ -1, 2, 0, -1 }), MatchRows(table, ThreeCells(), names).rowOfVertex);
  EXPECT_EQ("the labels are names ('b', ...), those of the tissue are numbers",
            RefusalOf([&] { MatchRows(table, ThreeCells(), {}); }));
  table.names = { "x" };
  EXPECT_EQ("the labels are names ('x', ...), of which the tissue has none: its first is 'a'",
            RefusalOf([&] { MatchRows(table, ThreeCells(), names); }));
  table.labels = { 9 };
  table.names = { "9" };
  EXPECT_EQ("no row has the label of a cell: the first is '9', the cells' are 2 to 7",
            RefusalOf([&] { MatchRows(table, ThreeCells(), {}); }));
}
