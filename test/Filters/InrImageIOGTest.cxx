/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "StackTestFiles.h"
#include "itkInrImageIO.h"
#include "itk_zlib.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
class InrImageIO : public TemporaryFolderTest
{
protected:
  /** A header of 3 x 2 x 4 voxels, filled up to a number of blocks. */
  static std::string
  MakeHeader(const std::string & type, const std::string & more, std::size_t blocks = 1)
  {
    std::string header =
      "#INRIMAGE-4#{\nXDIM=3\nYDIM=2\nZDIM=4\n" + type + "\nSCALE=2**0\nVX=0.3\nVY=0.4\nVZ=0.9\n" + more;
    header.resize(256 * blocks - 4, '\n');
    return header + "##}\n";
  }

  template <typename TPixel>
  std::string
  MakePixels(bool isBigEndian, std::size_t components = 1)
  {
    std::string bytes;
    for (std::size_t i = 0; i < 24 * components; ++i)
    {
      const auto  value = static_cast<TPixel>(i + 200);
      std::string pixel(reinterpret_cast<const char *>(&value), sizeof(value));
      if (isBigEndian)
      {
        std::reverse(pixel.begin(), pixel.end());
      }
      bytes += pixel;
    }
    return bytes;
  }

  std::string
  Write(const std::string & name, const std::string & bytes)
  {
    const std::string path = this->PathOf(name);
    // Without compression where the name has no .gz: mode T.
    const gzFile file = gzopen(path.c_str(), name.find(".gz") != std::string::npos ? "wb" : "wbT");
    gzwrite(file, bytes.data(), static_cast<unsigned int>(bytes.size()));
    gzclose(file);
    return path;
  }

  template <typename TPixel>
  void
  ExpectPixels(const std::string & path, unsigned int channel = 0, std::size_t channels = 1)
  {
    const auto io = itk::InrImageIO::New();
    io->SetChannel(channel);
    ASSERT_TRUE(io->CanReadFile(path.c_str()));
    const auto image = ReadStack<TPixel>(io, path);
    const auto size = image->GetLargestPossibleRegion().GetSize();
    ASSERT_EQ(size, (itk::Size<3>{ { 3, 2, 4 } }));
    for (std::size_t i = 0; i < 24; ++i)
    {
      const std::size_t first = channel > 0 ? channel - 1 : 0;
      EXPECT_EQ(image->GetBufferPointer()[i], static_cast<TPixel>(channels * i + first + 200)) << path << ' ' << i;
    }
    ExpectSpacing(image.GetPointer(), { { 0.3, 0.4, 0.9 } });
    EXPECT_TRUE(io->GetIsInMicrometers());
  }
};

const std::string UInt16 = "TYPE=unsigned fixed\nPIXSIZE=16 bits\n";
} // namespace

TEST_F(InrImageIO, ReadsBothByteOrdersGzippedOrNot)
{
  for (const bool isBig : { false, true })
  {
    const std::string header = MakeHeader(UInt16 + "VDIM=1\nCPU=" + (isBig ? "sun" : "decm"), "");
    const std::string bytes = header + this->MakePixels<std::uint16_t>(isBig);
    this->ExpectPixels<std::uint16_t>(this->Write("a.inr", bytes));
    this->ExpectPixels<std::uint16_t>(this->Write("a.inr.gz", bytes));
  }
}

TEST_F(InrImageIO, ReadsLongHeadersAndOtherTypes)
{
  const std::string more = "# " + std::string(300, 'x') + "\n#GEOMETRY=CARTESIAN\n";
  this->ExpectPixels<std::uint16_t>(
    this->Write("a.inr.gz", MakeHeader(UInt16 + "VDIM=1\nCPU=decm", more, 3) + this->MakePixels<std::uint16_t>(false)));
  this->ExpectPixels<int>(this->Write(
    "b.inr", MakeHeader("TYPE=signed fixed\nPIXSIZE=32 bits\nVDIM=1\nCPU=pc", "") + this->MakePixels<int>(false)));
  this->ExpectPixels<float>(this->Write(
    "c.inr", MakeHeader("TYPE=float\nPIXSIZE=32 bits\nVDIM=1\nCPU=pc", "") + this->MakePixels<float>(false)));
  this->ExpectPixels<unsigned char>(this->Write(
    "d.inr",
    MakeHeader("TYPE=unsigned fixed\nPIXSIZE=8 bits\nVDIM=1\nCPU=alpha", "") + this->MakePixels<unsigned char>(false)));
}

TEST_F(InrImageIO, TakesComponentsForChannels)
{
  const std::string path =
    this->Write("a.inr", MakeHeader(UInt16 + "VDIM=2\nCPU=decm", "") + this->MakePixels<std::uint16_t>(false, 2));
  this->ExpectPixels<std::uint16_t>(path, 2, 2);
  const auto io = itk::InrImageIO::New();
  io->SetFileName(path);
  EXPECT_NE(WordsOf([&] { io->ReadImageInformation(); }).find("2 channels"), std::string::npos);
}

TEST_F(InrImageIO, RefusesFilesThatAreCutOff)
{
  const std::string bytes = MakeHeader(UInt16 + "VDIM=1\nCPU=decm", "") + this->MakePixels<std::uint16_t>(false);
  const auto        words = [this](const std::string & content) {
    const std::string path = this->Write("a.inr", content);
    return WordsOf([&] { ReadStack<std::uint16_t>(itk::InrImageIO::New(), path); });
  };
  EXPECT_NE(words(bytes.substr(0, 100)).find("cut off or broken"), std::string::npos);
  EXPECT_NE(words(bytes.substr(0, bytes.size() - 1)).find("it ends in slice 4 of 4"), std::string::npos);
  EXPECT_NE(words(MakeHeader("TYPE=packed\nPIXSIZE=8 bits\n", "")).find("TYPE=packed"), std::string::npos);
  EXPECT_FALSE(itk::InrImageIO::New()->CanReadFile(this->Write("b.inr", "no image").c_str()));
}
