/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// Headers that no reader of ITK is asked about, and those of other programs that are read. All within moments.
#include "Shared/Images/ImageHeaderCheck.h"
#include "RefusalOf.h"
#include "TemporaryFolder.h"

#include <sys/stat.h>

#include <cstring>
#include <limits>
#include <map>

namespace
{
namespace fs = std::filesystem;

class ImageHeaderCheckTest : public TemporaryFolderTest
{
protected:
  /** What is said of a file of this text. */
  std::string
  Judge(const std::string & name, const std::string & text) const
  {
    WriteLines(name, text);
    return RefusalOf([&] { tissue::RequireSoundHeader(PathOf(name)); });
  }

  void
  ExpectRefusal(const std::string & name, const std::string & text, const std::string & part) const
  {
    const std::string message = Judge(name, text);
    EXPECT_NE(message.find(part), std::string::npos) << text.substr(0, 300) << "\n: " << message;
    EXPECT_LT(message.size(), 400u);
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
};

const std::string voxels(64, '\1');

std::string
Meta(const std::string & lines, const std::string & sizes = "4 4 4", const std::string & dimensions = "3")
{
  return "ObjectType = Image\nNDims = " + dimensions + "\nDimSize = " + sizes + "\nElementType = MET_UCHAR\n" + lines;
}

std::string
Nrrd(const std::string & lines, const std::string & sizes = "4 4 4", const std::string & dimension = "3")
{
  return "NRRD0004\ntype: uint8\ndimension: " + dimension + "\nsizes: " + sizes + "\nencoding: raw\n" + lines;
}

const std::string local = "ElementDataFile = LOCAL\n" + voxels;
} // namespace

TEST_F(ImageHeaderCheckTest, OnlyRegularFilesAreRead)
{
  ASSERT_EQ(mkfifo(PathOf("pipe.mha").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", PathOf("zero.nrrd"));
  for (const char * name : { "pipe.mha", "zero.nrrd" })
  {
    EXPECT_EQ(RefusalOf([&] { tissue::RequireSoundHeader(PathOf(name)); }), "not a regular file");
  }
}

TEST_F(ImageHeaderCheckTest, MetaImagesThatBreakItsReader)
{
  EXPECT_EQ(Judge("a.mha", Meta(local)), "");
  EXPECT_EQ(Judge("text.mha", "Dear reader,\n"), "");
  for (const char * dimensions : { "1000000000", "-1", "0", "11", "nan", "3.5", "1e400" })
  {
    ExpectRefusal("a.mha", Meta(local, "4 4 4", dimensions), "the header has NDims = ");
  }
  for (const char * sizes : { "-4 4 4", "0 4 4", "4 4", "4 4 x", "4 4 nan", "4 4 1e300", "4 4 4000000000" })
  {
    ExpectRefusal("a.mha", Meta(local, sizes), "the header has DimSize = ");
  }
  ExpectRefusal(
    "a.mha", Meta(local, "2000 2000 2000"), "it holds 64 bytes of voxels, those of its header need at least");
  ExpectRefusal("a.mha", Meta(local, "2147483647 2147483647 2147483647"), "more voxels than can be counted");
  ExpectRefusal("a.mha", Meta("CompressedData = True\n" + local, "2000 2000 2000"), "need at least 7751937");
  ExpectRefusal("a.mha",
                Meta("CompressedData = True\nCompressedDataSize = 18446744073709551615\n" + local),
                "CompressedDataSize = ");
  ExpectRefusal("a.mha", Meta("BinaryData = False\n" + local), "need at least 127");
  ExpectRefusal("a.mha", Meta("ElementNumberOfChannels = 1000000000\n" + local), "ElementNumberOfChannels = ");
  ExpectRefusal("a.mha", Meta("HeaderSize = 1e18\n" + local), "HeaderSize = ");
  ExpectRefusal("a.mha", "ObjectType = Image\nNDims = 3\nElementType = MET_UCHAR\n" + local, "no DimSize");
  ExpectRefusal("a.mha", "ObjectType = Image\nDimSize = 4 4 4\nElementType = MET_UCHAR\n" + local, "no NDims");
  ExpectRefusal("a.mha", Meta(""), "no ElementDataFile");
  ExpectRefusal("a.mha", Meta("ElementSpacing = nan 1 1\n" + local), "'nan' is no number");
  ExpectRefusal("a.mha", Meta("TransformMatrix = 1 0 0 0 1 0 0 0\n" + local), "which must have 9 numbers");
  ExpectRefusal(
    "a.mha", Meta("Offset = 0 0 0" + std::string(400, ' ') + std::string(400, '0') + "\n" + local), "Offset");
  ExpectRefusal("a.mha", Meta("Comment = " + std::string(300, 'x') + "\n" + local), "a Comment of 300 characters");
  ExpectRefusal("a.mha", Meta(std::string(300000, 'x') + " = 1\n" + local), "a line is NAME = VALUE");
  ExpectRefusal("a.mha", Meta("no separator\n" + local), "has the line 'no separator'");
  ExpectRefusal("a.mha", "Comment" + std::string(20000000, 'x'), "the header does not end");
}

TEST_F(ImageHeaderCheckTest, NamesOfVoxelFilesThatAreNotRead)
{
  WriteLines("a.raw", voxels);
  WriteLines("b.raw", voxels);
  fs::create_directory(PathOf("folder"));
  ASSERT_EQ(mkfifo(PathOf("pipe").c_str(), 0600), 0);
  const std::map<std::string, std::string> parts{
    { std::string(300000, 'x'), "characters" },
    { std::string(2000, 'x'), "has 2000 characters" },
    { "%s%n", "pattern of its files" },
    { "%s%n 1 2 1", "must have one number" },
    { "%9999999d 1 2 1", "must have one number" },
    { "%d%s 1 2 1", "must have one number" },
    { "a%d.raw 1 99999999 1", "do not lead from the first to the last" },
    { "a%d.raw 1 2 0", "do not lead from the first to the last" },
    { "a%d.raw 2 1 1", "do not lead from the first to the last" },
    { std::string(100, 'x') + "%d 1 2 1", "pattern of its files" },
    { "self.", "names itself" },
    { "/etc/passwd", "is not in the folder of the header" },
    { "../a.raw", "is not in the folder of the header" },
    { "folder/../../a.raw", "is not in the folder of the header" },
    { "/dev/zero", "is not in the folder of the header" },
    { "pipe", "is not a regular file" },
    { "folder", "is not a regular file" },
    { "none.raw", "is not there" },
  };
  for (const auto & [name, part] : parts)
  {
    const bool isSelf = name == "self.";
    ExpectRefusal("self.mhd",
                  Meta("ElementDataFile = " + (isSelf ? "self.mhd" : name) + "\n"),
                  isSelf || name.size() < 9000 ? part : "a line is");
    // A number of NRRD's pattern may fall; its reader has no limit of its own to the pattern's length.
    if (part.find("pattern of") == std::string::npos)
    {
      ExpectRefusal("self.nhdr", Nrrd("data file: " + (isSelf ? "self.nhdr" : name) + "\n"), part);
    }
  }
  ExpectRefusal("self.nhdr", Nrrd("data file: %s%n\n"), "pattern of its files");
  ExpectRefusal("self.mhd", Meta("ElementDataFile = LIST\na.raw\nb%d.raw\n"), "which is a pattern");
  ExpectRefusal("self.mhd", Meta("ElementDataFile = a.raw\n", "5 4 4"), "need at least 80");
}

TEST_F(ImageHeaderCheckTest, HeadersOfOtherPrograms)
{
  WriteLines("a.raw", voxels);
  for (int slice = 1; slice <= 4; ++slice)
  {
    WriteLines("slice00" + std::to_string(slice) + ".raw", std::string(16, '\1'));
  }
  fs::create_directory(PathOf("raw"));
  fs::create_symlink(PathOf("a.raw"), PathOf("raw/link.raw"));
  for (const char * file : { "a.raw",
                             "./a.raw",
                             "raw/link.raw",
                             "slice%03d.raw 1 4 1",
                             "LIST\nslice001.raw\nslice002.raw\nslice003.raw\nslice004.raw" })
  {
    EXPECT_EQ(Judge("a.mhd", Meta("ElementDataFile = " + std::string(file) + "\n")), "") << file;
    EXPECT_EQ(Judge("a.nhdr", Nrrd("data file: " + std::string(file) + "\n")), "") << file;
  }
  EXPECT_EQ(Judge("a.nhdr", Nrrd("datafile: slice%03d.raw 4 1 -1\n")), "");
  EXPECT_EQ(Judge("a.mhd", Meta("ElementDataFile = " + PathOf("a.raw") + "\n")), "");
  EXPECT_EQ(
    Judge(
      "a.mhd",
      Meta("Comment = of Fiji: x = y\nID = 3\nColor = 1 0 0 1\nHeaderSize = -1\nElementSpacing = .2 .2 1e0\n" + local)),
    "");
  // 3D Slicer's.
  EXPECT_EQ(
    Judge("a.seg.nrrd",
          Nrrd("# Complete NRRD file format specification at:\nspace: left-posterior-superior\nspace directions: "
               "(0.2,0,0) (0,0.2,0) (0,0,1)\nkinds: domain domain domain\nendian: little\nspace origin: "
               "(0,0,0)\nmeasurement frame: (1,0,0) (0,1,0) (0,0,1)\nSegment0_ID:=Segment_1\n\n" +
               voxels)),
    "");
}

TEST_F(ImageHeaderCheckTest, NrrdsThatPromiseWhatIsNotThere)
{
  EXPECT_EQ(Judge("a.nrrd", Nrrd("\n" + voxels)), "");
  for (const char * dimension : { "1000000000", "-1", "0", "17", "nan" })
  {
    ExpectRefusal("a.nrrd", Nrrd("\n" + voxels, "4 4 4", dimension), "the header has dimension = ");
  }
  for (const char * sizes : { "-4 4 4", "0 4 4", "4 4", "4 4 x", "" })
  {
    ExpectRefusal("a.nrrd", Nrrd("\n" + voxels, sizes), "the header has sizes = ");
  }
  ExpectRefusal("a.nrrd", Nrrd("\n" + voxels, "2000 2000 2000"), "need at least 8000000000");
  ExpectRefusal("a.nrrd", Nrrd("\n" + voxels, "1000000000000 1000000000000 9"), "more voxels than can be counted");
  ExpectRefusal("a.nrrd", Nrrd("encoding: gzip\n\n" + voxels, "2000 2000 2000"), "need at least 7751937");
  ExpectRefusal("a.nrrd", Nrrd("line skip: 1000000000000\n\n" + voxels), "it holds 0 bytes");
  ExpectRefusal("a.nrrd", Nrrd("byte skip: -2\n\n" + voxels), "byte skip = -2");
  for (const char * field : { "space: ", "encoding: ", "space ", "endian: " })
  {
    ExpectRefusal("a.nrrd", Nrrd(field + std::string(600, 'x') + "\n\n" + voxels), "characters, the format takes 200");
  }
  EXPECT_EQ(Judge("a.nrrd", Nrrd("content: " + std::string(300000, 'x') + "\n\n" + voxels)), "");
}

TEST_F(ImageHeaderCheckTest, NiftisWhosePlacesAreNoNumbers)
{
  std::string header(352, '\0');
  const auto  set = [&header](std::size_t place, auto value) { std::memcpy(&header[place], &value, sizeof(value)); };
  set(0, std::int32_t(348));
  set(40, std::int16_t(3));
  set(344, 'n');
  EXPECT_EQ(Judge("a.nii", header + voxels), "");
  for (const std::size_t place : { 80, 256, 308, 324 })
  {
    set(place, std::numeric_limits<float>::quiet_NaN());
    ExpectRefusal("a.nii", header + voxels, "the header has nan at byte " + std::to_string(place));
    ExpectRefusal("a.hdr", header, "the header has nan at byte");
    WriteLines("a.img", voxels);
    EXPECT_NE(RefusalOf([&] { tissue::RequireSoundHeader(PathOf("a.img")); }), "");
    set(place, 0.0f);
  }
  set(40, std::int16_t(8));
  ExpectRefusal("a.nii", header + voxels, "the header has 8 dimensions");
}
