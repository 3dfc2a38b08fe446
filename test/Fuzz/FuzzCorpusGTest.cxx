/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// The inputs of the corpus, small ones of each kind and those that once failed, named after what they did.
#include "FuzzTargets.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace
{
using Target = int (*)(const std::uint8_t *, std::size_t);

void
Replay(const std::string & name, Target target)
{
  const std::filesystem::path folder = std::filesystem::path(FUZZ_CORPUS) / name;
  std::size_t                 number = 0;
  for (const auto & entry : std::filesystem::directory_iterator(folder))
  {
    SCOPED_TRACE(entry.path().filename().string());
    std::ifstream     file(entry.path(), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    EXPECT_EQ(target(reinterpret_cast<const std::uint8_t *>(bytes.data()), bytes.size()), 0);
    ++number;
  }
  EXPECT_GT(number, 0u);
}
} // namespace

TEST(FuzzCorpus, LabelImages)
{
  Replay("LabelImage", tissue_test::FuzzLabelImage);
}

TEST(FuzzCorpus, Points)
{
  Replay("Points", tissue_test::FuzzPoints);
}

TEST(FuzzCorpus, PointTables)
{
  Replay("PointTable", tissue_test::FuzzPointTable);
}

TEST(FuzzCorpus, ImageHeaders)
{
  Replay("ImageHeader", tissue_test::FuzzImageHeader);
}

TEST(FuzzCorpus, CommandLines)
{
  Replay("CommandLine", tissue_test::FuzzCommandLine);
}
