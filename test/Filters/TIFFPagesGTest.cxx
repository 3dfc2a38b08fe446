/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TIFFPages.h"

#include "StackTestFiles.h"

#include <gtest/gtest.h>

namespace
{
class TIFFPagesFiles : public TemporaryFolderTest
{
protected:
  /** What is read of a page of a file of three. */
  template <typename TPixel>
  std::vector<TPixel>
  WriteAndRead(const TIFFRecipe & recipe, std::size_t page, std::size_t sample = 0)
  {
    const std::string path = this->PathOf("a.tif");
    WriteTIFF<TPixel>(path, recipe, 3);
    tissue::TIFFPages   pages(path);
    std::vector<TPixel> pixels(std::size_t{ StackWidth } * StackHeight);
    pages.ReadPage(page, sample, reinterpret_cast<char *>(pixels.data()));
    return pixels;
  }
};
} // namespace

TEST_F(TIFFPagesFiles, AreReadAlikeHoweverTheyAreWritten)
{
  const auto page = MakePage<std::uint16_t>(2);
  for (const int compression : { COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS })
  {
    for (const std::uint32_t tileSize : { 0u, 16u, 32u })
    {
      for (const char * mode : { "w", "wb", "w8", "w8b" })
      {
        TIFFRecipe recipe;
        recipe.mode = mode;
        recipe.compression = compression;
        recipe.tileSize = tileSize;
        EXPECT_EQ(this->WriteAndRead<std::uint16_t>(recipe, 2), page) << compression << ' ' << tileSize << ' ' << mode;
      }
    }
  }
}

TEST_F(TIFFPagesFiles, GiveOneSampleOfSeveral)
{
  for (const std::uint32_t tileSize : { 0u, 16u })
  {
    TIFFRecipe recipe;
    recipe.samples = 2;
    recipe.tileSize = tileSize;
    const auto                 both = MakePage<std::uint16_t>(1, 2);
    std::vector<std::uint16_t> second;
    for (std::size_t i = 1; i < both.size(); i += 2)
    {
      second.push_back(both[i]);
    }
    EXPECT_EQ(this->WriteAndRead<std::uint16_t>(recipe, 1, 1), second) << tileSize;
    recipe.isPlanar = true;
    EXPECT_EQ(this->WriteAndRead<std::uint16_t>(recipe, 1, 1), MakePage<std::uint16_t>(3)) << tileSize;
  }
}

TEST_F(TIFFPagesFiles, LeaveOutPreviews)
{
  TIFFRecipe recipe;
  recipe.numberOfPreviews = 1;
  EXPECT_EQ(this->WriteAndRead<std::uint8_t>(recipe, 0), MakePage<std::uint8_t>(1));
  EXPECT_EQ(tissue::TIFFPages(this->PathOf("a.tif")).GetNumberOfPages(), 2u);
  recipe.numberOfPreviews = 3;
  EXPECT_EQ(this->WriteAndRead<std::uint8_t>(recipe, 0), MakePage<std::uint8_t>(0)) << "all are such";
}

TEST_F(TIFFPagesFiles, UnpackPixelsOfLessThanAByte)
{
  const std::string path = this->PathOf("bits.tif");
  for (const int bits : { 1, 2, 4 })
  {
    TIFF * const file = TIFFOpen(path.c_str(), "w");
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, 5);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, 1);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, bits);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    unsigned char row[] = { 0xB4, 0x9C, 0x70 };
    TIFFWriteScanline(file, row, 0, 0);
    TIFFClose(file);
    char pixels[5];
    tissue::TIFFPages(path).ReadPage(0, 0, pixels);
    const std::vector<char> expected = bits == 1   ? std::vector<char>{ 1, 0, 1, 1, 0 }
                                       : bits == 2 ? std::vector<char>{ 2, 3, 1, 0, 2 }
                                                   : std::vector<char>{ 11, 4, 9, 12, 7 };
    EXPECT_EQ(std::vector<char>(pixels, pixels + 5), expected) << bits;
  }
}

TEST_F(TIFFPagesFiles, AreSplitFromAPageThatHasMoreBehindIt)
{
  const std::string path = this->PathOf("one.tif");
  for (const char * mode : { "wl", "wb" })
  {
    TIFFRecipe recipe;
    recipe.mode = mode;
    recipe.rowsPerStrip = 1000;
    WriteTIFF<std::uint16_t>(path, recipe, 1);
    // The pixels of the page are before its directory; what follows goes to a copy with its directory in front.
    tissue::TIFFPages whole(path);
    EXPECT_FALSE(whole.SplitSinglePage(2)) << "the file is too short";
    EXPECT_EQ(whole.GetNumberOfPages(), 1u);
    EXPECT_TRUE(whole.SplitSinglePage(1));
    std::vector<std::uint16_t> pixels(std::size_t{ StackWidth } * StackHeight);
    whole.ReadPage(0, 0, reinterpret_cast<char *>(pixels.data()));
    EXPECT_EQ(pixels, MakePage<std::uint16_t>(0)) << mode;
  }
}

TEST_F(TIFFPagesFiles, TellThatTheFileIsCutOff)
{
  const std::string path = this->PathOf("a.tif");
  TIFFRecipe        recipe;
  recipe.compression = COMPRESSION_LZW;
  WriteTIFF<std::uint16_t>(path, recipe, 3);
  const auto size = std::filesystem::file_size(path);
  for (const double share : { 0.9, 0.5, 0.1 })
  {
    std::filesystem::resize_file(path, static_cast<std::uintmax_t>(share * static_cast<double>(size)));
    EXPECT_NE(WordsOf([&] { tissue::TIFFPages pages(path); }).find("cut off or broken"), std::string::npos) << share;
  }
  EXPECT_TRUE(tissue::TIFFPages::IsTIFF(path));
  std::ofstream(path) << "II*";
  EXPECT_FALSE(tissue::TIFFPages::IsTIFF(path));
}
