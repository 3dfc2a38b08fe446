/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/OutputFiles.h"
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

TEST_F(OutputFilesTest, VoxelsOfAnInputAreNotReplaced)
{
  struct Case
  {
    std::string header;
    std::string text;
    std::string data;
  };
  const std::string meta = "NDims = 3\nElementDataFile = ";
  const std::string nrrd = "NRRD0004\n# made by hand\ndimension: 3\n";
  for (const Case & c : { Case{ "a.mhd", meta + "a.raw", "a.raw" },
                          Case{ "a.mha", "NDims = 3\r\nElementDataFile=a b.raw\r\n", "a b.raw" },
                          Case{ "a.mhd", meta + "LIST 2\na1.raw\na2.raw\n", "a2.raw" },
                          Case{ "a.mhd", meta + "a%03d.raw 1 9 4\n", "a009.raw" },
                          Case{ "a.nhdr", nrrd + "data file: ./a.raw\n", "a.raw" },
                          Case{ "a.nhdr", nrrd + "datafile: LIST\na1.raw\na2.raw", "a2.raw" },
                          Case{ "a.nrrd", nrrd + "data file: a%d.raw 8 12 1\n\n", "a11.raw" },
                          Case{ "a.img", "", "a.hdr" },
                          Case{ "a.hdr.gz", "", "a.img.gz" } })
  {
    std::ofstream(PathOf(c.header)) << c.text;
    WriteText(PathOf(c.data));
    WriteText(PathOf("other.raw"));
    try
    {
      tissue::OutputFiles::RequireNotInput(PathOf(c.data), PathOf(c.header));
      FAIL() << c.data << " of " << c.text;
    }
    catch (const std::runtime_error & error)
    {
      EXPECT_EQ(error.what(),
                "Cannot write '" + PathOf(c.data) + "': it holds the voxels of the input '" + PathOf(c.header) + "'");
    }
    EXPECT_NO_THROW(tissue::OutputFiles::RequireNotInput(PathOf("other.raw"), PathOf(c.header)));
    std::filesystem::remove(PathOf(c.data));
    EXPECT_NO_THROW(tissue::OutputFiles::RequireNotInput(PathOf(c.data), PathOf(c.header)));
  }
  // Voxels behind the header, which are no lines of it.
  std::ofstream(PathOf("b.nrrd")) << nrrd << "\ndata file: other.raw\n";
  std::ofstream(PathOf("b.mha")) << meta << "LOCAL\nother.raw\n";
  for (const char * header : { "b.nrrd", "b.mha", "none.mhd", "none.csv" })
  {
    EXPECT_NO_THROW(tissue::OutputFiles::RequireNotInput(PathOf("other.raw"), PathOf(header))) << header;
  }
}

namespace
{
/** Writes a file and as many pieces. */
tissue::OutputFiles::Writer
WritePieces(int number)
{
  return [number](const std::string & path) {
    WriteText(path);
    const fs::path folder = fs::path(path).parent_path() / fs::path(path).stem();
    fs::create_directory(folder);
    for (int i = 0; i < number; ++i)
    {
      WriteText((folder / (folder.filename().string() + "_" + std::to_string(i) + ".vtp")).string());
    }
  };
}
} // namespace

TEST_F(OutputFilesTest, PiecesAppearWithTheirFileAndReplaceThoseBefore)
{
  for (const int number : { 3, 2 })
  {
    tissue::OutputFiles files;
    files.AddWithPieces(PathOf("a.seg.vtm"), WritePieces(number));
    EXPECT_EQ(fs::exists(PathOf("a.seg/a.seg_2.vtp")), number == 2) << "the pieces of before, until the commit";
    files.Commit();
    EXPECT_EQ(List(), "a.seg a.seg.vtm ");
    EXPECT_TRUE(fs::exists(PathOf("a.seg/a.seg_1.vtp")));
    EXPECT_EQ(fs::exists(PathOf("a.seg/a.seg_2.vtp")), number == 3);
  }
}

TEST_F(OutputFilesTest, NoPieceIsLeftWhereTheWriterFails)
{
  try
  {
    tissue::OutputFiles files;
    files.AddWithPieces(PathOf("a.vtm"), [](const std::string & path) {
      WritePieces(2)(path);
      throw std::runtime_error("no ink");
    });
    FAIL() << "the error of the writer is lost";
  }
  catch (const std::runtime_error & error)
  {
    EXPECT_EQ(error.what(), "Cannot write '" + PathOf("a.vtm") + "': no ink");
  }
  EXPECT_EQ(List(), "");
}

TEST_F(OutputFilesTest, AFolderOfOtherFilesIsNotTakenForPieces)
{
  fs::create_directory(PathOf("a"));
  WriteText(PathOf("a/a_0.vtp"));
  tissue::OutputFiles::RequireWritableWithPieces(PathOf("a.vtm"));
  WriteText(PathOf("a/thesis.txt"));
  for (const bool isBefore : { true, false })
  {
    try
    {
      isBefore ? tissue::OutputFiles::RequireWritableWithPieces(PathOf("a.vtm"))
               : tissue::OutputFiles().AddWithPieces(PathOf("a.vtm"), WritePieces(1));
      FAIL() << "the folder would be lost";
    }
    catch (const std::runtime_error & error)
    {
      EXPECT_NE(std::string(error.what()).find("'thesis.txt', which is none and would be lost"), std::string::npos)
        << error.what();
    }
  }
  EXPECT_TRUE(fs::exists(PathOf("a/thesis.txt")));
  WriteText(PathOf("b"));
  EXPECT_THROW(tissue::OutputFiles::RequireWritableWithPieces(PathOf("b.vtm")), std::runtime_error);
}
