/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "OMELayout.h"

#include "StackTestFiles.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace tissue;

/** OME-XML of 2 channels, 3 slices, 4 frames. */
std::string
MakeXML(const std::string & order, const std::string & pixels, const std::string & content,
        const std::string & more = "")
{
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Warning: this comment is an OME-XML metadata block -->\n"
         "<OME xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\" UUID=\"urn:uuid:1\"><Image ID=\"Image:0\">"
         "<Pixels ID=\"Pixels:0\" DimensionOrder=\"" +
         order + "\" Type=\"uint16\" SizeX=\"48\" SizeY=\"44\" SizeC=\"2\" SizeZ=\"3\" SizeT=\"4\" " + pixels + ">" +
         content + "</Pixels></Image>" + more + "</OME>";
}

const std::string OneBlock = "<TiffData/>";
} // namespace

TEST(OMELayout, HasPlanesInAnyOrder)
{
  const std::size_t sizes[] = { 2, 3, 4 };
  std::string       order = "CTZ";
  do
  {
    const auto layout = ReadOMELayout(MakeXML("XY" + order, "", OneBlock), "a.ome.tif");
    ASSERT_TRUE(layout);
    std::size_t index[3]{};
    for (std::ptrdiff_t page = 0; page < 24; ++page)
    {
      EXPECT_EQ(layout->PageOf(index[0], index[1], index[2]), page) << order;
      // One further along the first axis, with a carry to the next.
      for (const char axis : order)
      {
        const std::size_t which = std::string("CZT").find(axis);
        if (++index[which] < sizes[which])
        {
          break;
        }
        index[which] = 0;
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(OMELayout, FollowsTheBlocks)
{
  const auto layout = ReadOMELayout(MakeXML("XYZCT",
                                            "",
                                            "<TiffData IFD=\"5\" FirstC=\"1\" FirstZ=\"2\" FirstT=\"3\"/>"
                                            "<TiffData IFD=\"7\" PlaneCount=\"3\"/>"),
                                    "a.ome.tif");
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->PageOf(1, 2, 3), 5);
  EXPECT_EQ(layout->PageOf(0, 0, 0), 7);
  EXPECT_EQ(layout->PageOf(0, 2, 0), 9);
  EXPECT_EQ(layout->PageOf(1, 0, 0), -1) << "no block has it";
}

TEST(OMELayout, LeavesToOtherFilesWhatIsTheirs)
{
  const auto block = [](const std::string & first, const std::string & file, const std::string & uuid) {
    return "<TiffData IFD=\"0\" PlaneCount=\"3\" " + first + "><UUID FileName=\"" + file + "\">" + uuid +
           "</UUID></TiffData>";
  };
  const std::string two =
    block("FirstC=\"0\"", "a.ome.tif", "urn:uuid:1") + block("FirstC=\"1\"", "b.ome.tif", "urn:uuid:2");
  auto layout = ReadOMELayout(MakeXML("XYZCT", "", two), "renamed.ome.tif");
  EXPECT_EQ(layout->PageOf(0, 1, 0), 1);
  EXPECT_EQ(layout->PageOf(1, 1, 0), -1);
  layout = ReadOMELayout(MakeXML("XYZCT", "", two), "b.ome.tif");
  EXPECT_EQ(layout->PageOf(1, 1, 0), 1) << "by its name";
  layout = ReadOMELayout(MakeXML("XYZCT", "", block("", "old.ome.tif", "urn:uuid:9")), "renamed.ome.tif");
  EXPECT_EQ(layout->PageOf(0, 1, 0), 1) << "all of one file, which has another name now";
}

TEST(OMELayout, ReadsPhysicalSizesInAllUnits)
{
  const auto sizes = [](const std::string & pixels) {
    return ReadOMELayout(MakeXML("XYZCT", pixels, OneBlock), "a.ome.tif")->voxelSize;
  };
  const auto um = sizes("PhysicalSizeX=\"0.3\" PhysicalSizeY=\"0.4\" PhysicalSizeZ=\"0.9\"");
  EXPECT_EQ(um[0], 0.3);
  EXPECT_EQ(um[1], 0.4);
  EXPECT_EQ(um[2], 0.9);
  const auto others = sizes("PhysicalSizeX=\"300\" PhysicalSizeXUnit=\"nm\" PhysicalSizeY=\"0.5\" "
                            "PhysicalSizeYUnit=\"\xC2\xB5m\" PhysicalSizeZ=\"2\" PhysicalSizeZUnit=\"pixel\"");
  EXPECT_DOUBLE_EQ(others[0].value(), 0.3);
  EXPECT_EQ(others[1], 0.5);
  EXPECT_FALSE(others[2]) << "a pixel is no length";
}

TEST(OMELayout, WarnsOfFurtherImages)
{
  const std::string further = "<Image ID=\"Image:1\"><Pixels ID=\"P\" SizeZ=\"9\" DimensionOrder=\"XYZCT\"/></Image>";
  const auto        layout = ReadOMELayout(MakeXML("XYZCT", "", OneBlock, further), "a.ome.tif");
  EXPECT_EQ(layout->numberOfSlices, 3u);
  ASSERT_EQ(layout->warnings.size(), 1u);
  EXPECT_NE(layout->warnings[0].find("2 images"), std::string::npos);
}

TEST(OMELayout, TakesSamplesOfAPixelForChannelsOfOnePage)
{
  const auto layout =
    ReadOMELayout(MakeXML("XYCZT", "", "<Channel ID=\"C\" SamplesPerPixel=\"2\"/>" + OneBlock), "a.ome.tif");
  EXPECT_EQ(layout->numberOfChannels, 1u);
  EXPECT_EQ(layout->PageOf(0, 1, 0), 1);
}

TEST(OMELayout, RefusesWhatIsBroken)
{
  const auto words = [](const std::string & xml) { return WordsOf([&] { ReadOMELayout(xml, "a.ome.tif"); }); };
  EXPECT_NE(words("<OME><Image>").find("broken"), std::string::npos);
  EXPECT_NE(
    words("<!DOCTYPE OME [<!ENTITY a \"aa\"><!ENTITY b \"&a;&a;\">]><OME><Image>&b;</Image></OME>").find("broken"),
    std::string::npos);
  EXPECT_NE(words(MakeXML("XYQQQ", "", OneBlock)).find("DimensionOrder"), std::string::npos);
  EXPECT_NE(words(MakeXML("XYZCT", "", "<TiffData FirstZ=\"3\"/>")).find("outside"), std::string::npos);
  EXPECT_EQ(ReadOMELayout("<html/>", "a.tif"), std::nullopt);
  EXPECT_EQ(ReadOMELayout("<OME><BinaryOnly MetadataFile=\"b.ome.tif\"/></OME>", "a.tif"), std::nullopt);
}
