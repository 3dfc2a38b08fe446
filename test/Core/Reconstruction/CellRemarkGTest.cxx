/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/CellRemark.h"

#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"

#include <gtest/gtest.h>

#include <set>

namespace
{
using namespace tissue;
} // namespace

TEST(CellRemark, HasWordsOfEveryRemark)
{
  std::set<std::string> words;
  for (int i = 0; i < NumberOfRemarks; ++i)
  {
    const auto        remark = static_cast<Remark>(i);
    const std::string sentence = Describe({ 1, remark, 3.0 });
    EXPECT_TRUE(words.insert(ToString(remark)).second) << ToString(remark);
    EXPECT_FALSE(std::string(ToString(remark)).empty()) << i;
    EXPECT_FALSE(sentence.empty()) << ToString(remark);
    EXPECT_EQ(sentence.find_first_of("{}"), std::string::npos) << sentence;
    EXPECT_FALSE(std::string(DescribeSeveral(remark)).empty()) << ToString(remark);
  }
}

TEST(CellRemark, SaysItsValueInTheSingularAndThePlural)
{
  EXPECT_EQ(Describe({ 1, Remark::WallsLost, 1.0 }), "lost 1 wall that the image has");
  EXPECT_EQ(Describe({ 1, Remark::WallsLost, 2.0 }), "lost 2 walls that the image has");
  EXPECT_EQ(Describe({ 1, Remark::Repaired, 1.0 }), "has 1 false wall, by which its surface is one sphere");
  EXPECT_EQ(Describe({ 1, Remark::VolumeOff, 0.25 }), "has 0.25 times its volume in the image");
  EXPECT_EQ(Describe({ 1, Remark::NoClosedSphere, -4.0 }),
            "has a surface that is no closed sphere; its Euler characteristic is -4");
}

TEST(CellRemark, NamesWhatTheCheckOfTheMeshFinds)
{
  CellSurfaceCheck check;
  check.cells.resize(4);
  check.cells[3].eulerCharacteristic = -4;
  check.cellsWithoutTriangles = { 2 };
  check.cellsThatAreNoSphere = { 3 };
  const std::vector<CellRemark> remarks = CollectRemarks(check);
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0].cell, 2);
  EXPECT_EQ(remarks[0].remark, Remark::Missing);
  EXPECT_EQ(remarks[1].cell, 3);
  EXPECT_EQ(remarks[1].remark, Remark::NoClosedSphere);
  EXPECT_EQ(remarks[1].value, -4.0);
}
