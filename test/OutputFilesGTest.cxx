/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "OutputFiles.h"

#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace
{
namespace fs = std::filesystem;

void
WriteText(const std::string & path)
{
  std::ofstream(path) << "new";
}

class OutputFilesTest : public TemporaryFolderTest
{
protected:
  std::string
  RefusalOf(const std::string & path) const
  {
    try
    {
      tissue::OutputFiles::RequireWritable(path);
    }
    catch (const std::runtime_error & error)
    {
      return error.what();
    }
    return "accepted";
  }
};
} // namespace

TEST_F(OutputFilesTest, FilesAppearWithCommitAndWithTheirExtensions)
{
  tissue::OutputFiles files;
  std::string         temporaryPath;
  files.Add(PathOf("a.vtp"), [&](const std::string & path) {
    temporaryPath = path;
    WriteText(path);
  });
  files.Add(PathOf("b.csv"), WriteText);
  EXPECT_EQ(fs::path(temporaryPath).extension(), ".vtp");
  EXPECT_EQ(fs::path(temporaryPath).parent_path(), fs::canonical(m_Folder));
  EXPECT_FALSE(fs::exists(PathOf("a.vtp")));
  files.Commit();
  EXPECT_EQ(List(), "a.vtp b.csv ");
  EXPECT_EQ(ReadBytes(PathOf("a.vtp")), "new");
}

TEST_F(OutputFilesTest, NothingIsLeftAndNothingReplacedWhenOneFails)
{
  std::ofstream(PathOf("a.vtp")) << "old";
  try
  {
    tissue::OutputFiles files;
    files.Add(PathOf("a.vtp"), WriteText);
    files.Add(PathOf("b.csv"), [](const std::string &) { throw std::runtime_error("no ink"); });
    FAIL() << "the error of the writer is lost";
  }
  catch (const std::runtime_error & error)
  {
    EXPECT_EQ(error.what(), "Cannot write '" + PathOf("b.csv") + "': no ink");
  }
  EXPECT_EQ(List(), "a.vtp ");
  EXPECT_EQ(ReadBytes(PathOf("a.vtp")), "old");
}

TEST_F(OutputFilesTest, AnOldFileIsReplacedAndALinkKept)
{
  std::ofstream(PathOf("target.vtp")) << "old";
  fs::create_symlink("target.vtp", PathOf("link.vtp"));
  tissue::OutputFiles files;
  files.Add(PathOf("link.vtp"), WriteText);
  EXPECT_THROW(files.Add(PathOf("target.vtp"), WriteText), std::runtime_error);
  files.Commit();
  EXPECT_TRUE(fs::is_symlink(PathOf("link.vtp")));
  EXPECT_EQ(ReadBytes(PathOf("target.vtp")), "new");
  EXPECT_EQ(List(), "link.vtp target.vtp ");
}

TEST_F(OutputFilesTest, PathsThatCannotBeWrittenAreRefusedByReason)
{
  EXPECT_EQ(RefusalOf(PathOf("a.vtp")), "accepted");
  EXPECT_EQ(List(), "");
  EXPECT_NE(RefusalOf(PathOf("none/a.vtp")).find("there is no folder"), std::string::npos);
  EXPECT_NE(RefusalOf(m_Folder.string()).find("it is a folder"), std::string::npos);
  EXPECT_NE(RefusalOf("").find("Cannot write ''"), std::string::npos);
  const fs::path before = fs::current_path();
  fs::current_path(m_Folder);
  EXPECT_EQ(RefusalOf("relative.vtp"), "accepted");
  fs::current_path(before);
#ifdef __unix__
  EXPECT_NE(RefusalOf("/dev/null").find("it is not a regular file"), std::string::npos);
  EXPECT_NE(RefusalOf("/proc/a.vtp").find("Cannot write '/proc/a.vtp': "), std::string::npos);
#endif
}
