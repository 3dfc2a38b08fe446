/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "StackTestFiles.h"
#include "itkStackTIFFImageIO.h"

#include <itkExtractImageFilter.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{
class StackTIFFImageIO : public TemporaryFolderTest
{
protected:
  template <typename TPixel>
  void
  Write(const TIFFRecipe & recipe, std::size_t numberOfPages)
  {
    WriteTIFF<TPixel>(this->PathOf("a.tif"), recipe, numberOfPages);
  }

  itk::StackTIFFImageIO::Pointer
  Open(unsigned int channel = 0, unsigned int frame = 0)
  {
    const auto io = itk::StackTIFFImageIO::New();
    io->SetChannel(channel);
    io->SetFrame(frame);
    io->SetFileName(this->PathOf("a.tif"));
    return io;
  }

  std::string
  Refusal(unsigned int channel = 0, unsigned int frame = 0)
  {
    const auto io = this->Open(channel, frame);
    return WordsOf([&] { io->ReadImageInformation(); });
  }

  /** The page that is read as a slice, by its pixels. */
  template <typename TPixel>
  void
  ExpectSlices(const std::vector<std::size_t> & pages, unsigned int channel = 0, unsigned int frame = 0)
  {
    const auto image = ReadStack<TPixel>(this->Open(channel, frame), this->PathOf("a.tif"));
    ASSERT_EQ(image->GetLargestPossibleRegion().GetSize(2), pages.size());
    for (std::size_t z = 0; z < pages.size(); ++z)
    {
      EXPECT_EQ(SliceOf(image.GetPointer(), z), MakePage<TPixel>(pages[z])) << "slice " << z;
    }
  }

  template <typename TPixel>
  void
  ExpectType(itk::IOComponentEnum type)
  {
    this->Write<TPixel>({}, 2);
    const auto io = this->Open();
    io->ReadImageInformation();
    EXPECT_EQ(io->GetComponentType(), type);
    EXPECT_EQ(io->GetNumberOfComponents(), 1u);
    this->ExpectSlices<TPixel>({ 0, 1 });
  }

  /** What the file tells of the voxels' size, 0 where it does not; and whether in micrometres. */
  void
  ExpectSize(const TIFFRecipe & recipe, const std::array<double, 3> & expected, bool isInMicrometers)
  {
    this->Write<std::uint8_t>(recipe, 2);
    const auto io = this->Open();
    io->ReadImageInformation();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(io->HasSpacing(axis), expected[axis] > 0.0) << recipe.description << " axis " << axis;
      EXPECT_DOUBLE_EQ(io->GetSpacing(axis), expected[axis] > 0.0 ? expected[axis] : 1.0) << recipe.description;
    }
    EXPECT_EQ(io->GetIsInMicrometers(), isInMicrometers) << recipe.description;
  }

  static TIFFRecipe
  WithResolution(float x, float y, int unit, const std::string & description = {})
  {
    TIFFRecipe recipe;
    recipe.xResolution = x;
    recipe.yResolution = y;
    recipe.resolutionUnit = unit;
    recipe.description = description;
    return recipe;
  }
};
} // namespace

TEST_F(StackTIFFImageIO, ReadsAllTypesOfNumbers)
{
  this->ExpectType<std::uint8_t>(itk::IOComponentEnum::UCHAR);
  this->ExpectType<std::int8_t>(itk::IOComponentEnum::CHAR);
  this->ExpectType<std::uint16_t>(itk::IOComponentEnum::USHORT);
  this->ExpectType<std::int16_t>(itk::IOComponentEnum::SHORT);
  this->ExpectType<std::uint32_t>(itk::IOComponentEnum::UINT);
  this->ExpectType<std::int32_t>(itk::IOComponentEnum::INT);
  this->ExpectType<unsigned long long>(itk::IOComponentEnum::ULONGLONG);
  this->ExpectType<long long>(itk::IOComponentEnum::LONGLONG);
  this->ExpectType<float>(itk::IOComponentEnum::FLOAT);
  this->ExpectType<double>(itk::IOComponentEnum::DOUBLE);
}

TEST_F(StackTIFFImageIO, ReadsPalettesAsIndicesAndTheWhiteAsItIs)
{
  TIFFRecipe recipe;
  for (const int photometric : { PHOTOMETRIC_PALETTE, PHOTOMETRIC_MINISWHITE })
  {
    recipe.photometric = photometric;
    this->Write<std::uint8_t>(recipe, 3);
    this->ExpectSlices<std::uint8_t>({ 0, 1, 2 });
  }
}

TEST_F(StackTIFFImageIO, RefusesColours)
{
  TIFFRecipe recipe;
  recipe.photometric = PHOTOMETRIC_RGB;
  recipe.samples = 3;
  this->Write<std::uint8_t>(recipe, 2);
  EXPECT_NE(this->Refusal(1).find("RGB colours"), std::string::npos) << this->Refusal(1);
}

TEST_F(StackTIFFImageIO, ReadsTheChannelAndTheFrameThatAreChosen)
{
  TIFFRecipe recipe;
  recipe.description = "ImageJ=1.53t\nimages=12\nchannels=2\nslices=3\nframes=2\nhyperstack=true\n";
  this->Write<std::uint16_t>(recipe, 12);
  EXPECT_NE(this->Refusal().find("2 channels, of which one must be chosen"), std::string::npos);
  EXPECT_NE(this->Refusal(1).find("2 frames, of which one must be chosen"), std::string::npos);
  EXPECT_EQ(this->Refusal(1).find("channel"), std::string::npos);
  EXPECT_NE(this->Refusal(3, 1).find("2 channels, there is no channel 3"), std::string::npos);
  EXPECT_EQ(this->Refusal(2, 1), "");
  this->ExpectSlices<std::uint16_t>({ 0, 2, 4 }, 1, 1);
  this->ExpectSlices<std::uint16_t>({ 7, 9, 11 }, 2, 2);
  const auto io = this->Open();
  EXPECT_THROW(io->ReadImageInformation(), itk::ExceptionObject);
  EXPECT_EQ(io->GetNumberOfChannels(), 2u) << "known for want of a choice";
  EXPECT_EQ(io->GetNumberOfFrames(), 2u);
  this->Write<std::uint16_t>({}, 2);
  this->ExpectSlices<std::uint16_t>({ 0, 1 }, 5, 5);
}

TEST_F(StackTIFFImageIO, RefusesFramesOfASingleSlice)
{
  TIFFRecipe recipe;
  recipe.description = R"({"shape": [6, 18, 21], "axes": "TYX"})";
  this->Write<std::uint16_t>(recipe, 6);
  EXPECT_NE(this->Refusal().find("6 frames of one slice each"), std::string::npos) << this->Refusal();
}

TEST_F(StackTIFFImageIO, TakesSamplesOfAPixelForChannels)
{
  TIFFRecipe recipe;
  recipe.samples = 2;
  recipe.isPlanar = true;
  this->Write<std::uint16_t>(recipe, 3);
  EXPECT_NE(this->Refusal().find("2 channels"), std::string::npos);
  this->ExpectSlices<std::uint16_t>({ 1, 3, 5 }, 2);
}

TEST_F(StackTIFFImageIO, FollowsOMEXML)
{
  TIFFRecipe recipe;
  recipe.tileSize = 16;
  recipe.description =
    "<OME><Image><Pixels DimensionOrder=\"XYZCT\" SizeX=\"21\" SizeY=\"18\" SizeZ=\"3\" SizeC=\"2\" SizeT=\"1\" "
    "PhysicalSizeX=\"0.3\" PhysicalSizeY=\"0.3\" PhysicalSizeZ=\"0.9\"><TiffData/></Pixels></Image></OME>";
  this->Write<std::uint16_t>(recipe, 6);
  this->ExpectSlices<std::uint16_t>({ 3, 4, 5 }, 2);
  const auto io = this->Open(1);
  io->ReadImageInformation();
  EXPECT_EQ(io->GetSpacing(0), 0.3);
  EXPECT_EQ(io->GetSpacing(2), 0.9);
  EXPECT_TRUE(io->GetIsInMicrometers());
  this->Write<std::uint16_t>(recipe, 5);
  EXPECT_NE(this->Refusal(1).find("6 planes, but the file has 5"), std::string::npos) << this->Refusal(1);
}

TEST_F(StackTIFFImageIO, KnowsTheSizeOfAVoxelByTagsAndDescription)
{
  const auto        with = &StackTIFFImageIO::WithResolution;
  const float       px = 1.0f / 0.3f;
  const std::string imageJ = "ImageJ=1.53t\nimages=2\nslices=2\n";
  this->ExpectSize({}, { 0.0, 0.0, 0.0 }, false);
  this->ExpectSize(with(1.0f, 1.0f, RESUNIT_NONE, {}), { 0.0, 0.0, 0.0 }, false);
  this->ExpectSize(with(px, 2.0f, RESUNIT_NONE, imageJ + "unit=um\nspacing=0.9\n"), { 0.3, 0.5, 0.9 }, true);
  this->ExpectSize(with(px, px, RESUNIT_NONE, imageJ + "unit=um\n"), { 0.3, 0.3, 0.0 }, true);
  this->ExpectSize(with(1.0f, 1.0f, RESUNIT_NONE, imageJ + "unit=um\nspacing=0.9\n"), { 1.0, 1.0, 0.9 }, true);
  this->ExpectSize(with(px, px, RESUNIT_NONE, imageJ + "spacing=0.9\n"), { 0.3, 0.3, 0.9 }, false);
  this->ExpectSize(
    with(1e-3f * px, 1e-3f * px, RESUNIT_NONE, imageJ + "unit=nm\nspacing=900\n"), { 0.3, 0.3, 0.9 }, true);
  this->ExpectSize(with(1e4f * px, 1e4f * px, RESUNIT_CENTIMETER, {}), { 0.3, 0.3, 0.0 }, true);
  this->ExpectSize(with(84667.0f, 84667.0f, RESUNIT_INCH, {}), { 0.2999988, 0.2999988, 0.0 }, true);
  this->ExpectSize(with(300.0f, 300.0f, RESUNIT_INCH, {}), { 0.0, 0.0, 0.0 }, false);
  const auto io = this->Open();
  io->ReadImageInformation();
  ASSERT_EQ(io->GetWarnings().size(), 1u);
  EXPECT_NE(io->GetWarnings()[0].find("300 dots an inch"), std::string::npos);
  TIFFRecipe ofITK = with(50.8f, 50.8f, RESUNIT_INCH, {});
  ofITK.software = "InsightToolkit";
  this->ExpectSize(ofITK, { 0.5, 0.5, 0.0 }, false);
}

TEST_F(StackTIFFImageIO, ReadsARegionAlone)
{
  this->Write<std::uint16_t>({}, 5);
  using ImageType = itk::Image<std::uint16_t, 3>;
  const auto reader = itk::ImageFileReader<ImageType>::New();
  reader->SetImageIO(this->Open());
  reader->SetFileName(this->PathOf("a.tif"));
  reader->UpdateOutputInformation();
  const ImageType::RegionType region({ { 3, 5, 2 } }, { { 7, 4, 2 } });
  reader->GetOutput()->SetRequestedRegion(region);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetBufferedRegion(), region) << "no more is read";
  for (std::size_t z = 2; z < 4; ++z)
  {
    const auto page = MakePage<std::uint16_t>(z);
    EXPECT_EQ(reader->GetOutput()->GetPixel({ { 3, 5, static_cast<long>(z) } }), page[5 * StackWidth + 3]);
    EXPECT_EQ(reader->GetOutput()->GetPixel({ { 9, 8, static_cast<long>(z) } }), page[8 * StackWidth + 9]);
  }
}

TEST_F(StackTIFFImageIO, RefusesPagesThatAreNoSlicesOfOneImage)
{
  this->Write<std::uint16_t>({}, 2);
  TIFF * const file = TIFFOpen(this->PathOf("a.tif").c_str(), "a");
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, 5);
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, 1);
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  char row[5] = {};
  TIFFWriteScanline(file, row, 0, 0);
  TIFFClose(file);
  EXPECT_NE(this->Refusal().find("one is 21 x 18 of 16 bits, page 3 is 5 x 1 of 8 bits"), std::string::npos)
    << this->Refusal();
}

TEST_F(StackTIFFImageIO, WritesNothing)
{
  EXPECT_FALSE(itk::StackTIFFImageIO::New()->CanWriteFile("a.tif"));
  EXPECT_THROW(itk::StackTIFFImageIO::New()->Write(nullptr), itk::ExceptionObject);
}
