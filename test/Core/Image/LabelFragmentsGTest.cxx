/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Image/LabelFragments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace tissue;

namespace
{
constexpr Label Exterior = '.';

/** One string a layer, its rows separated by '/', its labels the characters; a run for each voxel or as long as can be.
 */
LabelRuns
RunsOf(const std::vector<std::string> & layers, bool isRunPerVoxel)
{
  LabelRuns labels;
  labels.rowsPerLayer = static_cast<std::size_t>(std::count(layers[0].begin(), layers[0].end(), '/')) + 1;
  for (const std::string & layer : layers)
  {
    std::int32_t x = 0;
    for (const char c : layer)
    {
      if (c == '/')
      {
        labels.endOfRow.push_back(labels.runs.size());
        x = 0;
        continue;
      }
      if (x > 0 && !isRunPerVoxel && labels.runs.back().label == c)
      {
        ++labels.runs.back().end;
      }
      else
      {
        labels.runs.push_back({ c, x, x + 1 });
      }
      ++x;
    }
    labels.endOfRow.push_back(labels.runs.size());
  }
  return labels;
}

std::vector<std::string>
TextOf(const LabelRuns & labels)
{
  std::vector<std::string> layers;
  std::size_t              run = 0;
  for (std::size_t row = 0; row < labels.endOfRow.size(); ++row)
  {
    if (row % labels.rowsPerLayer == 0)
    {
      layers.emplace_back();
    }
    else
    {
      layers.back() += '/';
    }
    for (; run < labels.endOfRow[row]; ++run)
    {
      layers.back().append(static_cast<std::size_t>(labels.runs[run].end - labels.runs[run].begin),
                           static_cast<char>(labels.runs[run].label));
    }
  }
  return layers;
}

/** By runs of either kind. */
void
ExpectMerged(const std::vector<std::string> & layers, const std::vector<std::string> & expected, std::int64_t changes)
{
  for (const bool isRunPerVoxel : { false, true })
  {
    LabelRuns labels = RunsOf(layers, isRunPerVoxel);
    EXPECT_EQ(MergeFragments(labels, Exterior), changes) << isRunPerVoxel;
    EXPECT_EQ(TextOf(labels), expected) << isRunPerVoxel;
  }
}
} // namespace

TEST(LabelFragments, LeavesCellsOfOnePieceAlone)
{
  // The two b of the first layer hold together by the second one.
  ExpectMerged({ "bab/aab", "bbb/abb" }, { "bab/aab", "bbb/abb" }, 0);
}

TEST(LabelFragments, ThePiecesOfACellButTheLargestGoToTheNeighbourOfMostFaces)
{
  // The lone a has a face with b and three with c, the one of the second layer among them.
  ExpectMerged({ "aabac/aabcc", "aabcc/aabcc" }, { "aabcc/aabcc", "aabcc/aabcc" }, 1);
}

TEST(LabelFragments, OfPiecesOfOneSizeTheFirstStays)
{
  ExpectMerged({ "abbac" }, { "abbbc" }, 1);
}

TEST(LabelFragments, OfNeighboursOfAsManyFacesThatOfTheLeastLabelTakesThePiece)
{
  ExpectMerged({ "aadab" }, { "aadbb" }, 1);
  ExpectMerged({ "aabad" }, { "aabbd" }, 1);
}

TEST(LabelFragments, VoxelsThatTouchByAnEdgeOrACornerAreApart)
{
  // Two b of two voxels each, and a lone a at a corner of the first.
  ExpectMerged({ "aab/aab/bba" }, { "aab/aab/aab" }, 3);
  ExpectMerged({ "ab/bb", "bb/ba" }, { "ab/bb", "bb/bb" }, 1);
}

TEST(LabelFragments, TheExteriorKeepsItsPiecesAtTheBorderAndLosesItsVoids)
{
  ExpectMerged({ ".aa/aaa/aa." }, { ".aa/aaa/aa." }, 0);
  const std::vector<std::string> voidInA{ "aaa/aaa/aaa", "aaa/a.a/aaa", "aaa/aaa/aaa" };
  ExpectMerged(voidInA, { "aaa/aaa/aaa", "aaa/aaa/aaa", "aaa/aaa/aaa" }, 1);
}

TEST(LabelFragments, APieceInTheExteriorBecomesExterior)
{
  ExpectMerged({ "aa..a../aa.....", "......./......." }, { "aa...../aa.....", "......./......." }, 1);
}

TEST(LabelFragments, TheLastRowOfALayerIsNoNeighbourOfTheFirstRowOfTheNext)
{
  // The last row of the first layer and the first one of the second follow on each other, but share no face.
  ExpectMerged({ "bb/aa", "a./.." }, { "bb/aa", "../.." }, 1);
}
