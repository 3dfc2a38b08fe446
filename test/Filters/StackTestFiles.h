/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef StackTestFiles_h
#define StackTestFiles_h

#include "TemporaryFolder.h"
#include "itkStackImageIOBase.h"

#include <itkImageFileReader.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

/** Sizes of a test's image: no two are the same, no multiples of a tile. */
constexpr std::uint32_t StackWidth = 21;
constexpr std::uint32_t StackHeight = 18;

/** How a TIFF file is written. */
struct TIFFRecipe
{
  std::uint32_t width = StackWidth;
  std::uint32_t height = StackHeight;
  /** Of TIFFOpen: "w8" BigTIFF, "wb" big-endian. */
  std::string mode = "w";
  std::string description;
  std::string software;
  int         compression = COMPRESSION_NONE;
  int         photometric = PHOTOMETRIC_MINISBLACK;
  int         samples = 1;
  bool        isPlanar = false;
  /** 0: strips. */
  std::uint32_t tileSize = 0;
  std::uint32_t rowsPerStrip = 3;
  /** Pixels a unit; 0: no tag. */
  float xResolution = 0.0f;
  float yResolution = 0.0f;
  int   resolutionUnit = RESUNIT_NONE;
  /** The first pages that are written have the flag of a preview. */
  std::size_t numberOfPreviews = 0;
};

/** A value for each voxel of a page that no other has within a byte's range of pages. */
template <typename TPixel>
std::vector<TPixel>
MakePage(std::size_t page, std::size_t samples = 1)
{
  std::vector<TPixel> pixels;
  for (std::size_t i = 0; i < std::size_t{ StackWidth } * StackHeight * samples; ++i)
  {
    pixels.push_back(static_cast<TPixel>((page * 41 + i) % 120));
  }
  return pixels;
}

template <typename TPixel>
void
SetTIFFTags(TIFF * file, const TIFFRecipe & recipe, bool isFirst)
{
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, recipe.width);
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, recipe.height);
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8 * sizeof(TPixel));
  TIFFSetField(file,
               TIFFTAG_SAMPLEFORMAT,
               std::is_floating_point_v<TPixel> ? SAMPLEFORMAT_IEEEFP
               : std::is_signed_v<TPixel>       ? SAMPLEFORMAT_INT
                                                : SAMPLEFORMAT_UINT);
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, recipe.samples);
  TIFFSetField(file, TIFFTAG_PLANARCONFIG, recipe.isPlanar ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
  TIFFSetField(file, TIFFTAG_COMPRESSION, recipe.compression);
  TIFFSetField(file, TIFFTAG_PHOTOMETRIC, recipe.photometric);
  if (recipe.photometric == PHOTOMETRIC_PALETTE)
  {
    std::vector<std::uint16_t> colors(std::size_t{ 1 } << (8 * sizeof(TPixel)), 777);
    TIFFSetField(file, TIFFTAG_COLORMAP, colors.data(), colors.data(), colors.data());
  }
  if (recipe.xResolution > 0.0f)
  {
    TIFFSetField(file, TIFFTAG_XRESOLUTION, recipe.xResolution);
    TIFFSetField(file, TIFFTAG_YRESOLUTION, recipe.yResolution);
    TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, recipe.resolutionUnit);
  }
  if (isFirst && !recipe.description.empty())
  {
    TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION, recipe.description.c_str());
  }
  if (!recipe.software.empty())
  {
    TIFFSetField(file, TIFFTAG_SOFTWARE, recipe.software.c_str());
  }
}

/** Writes one sample, or all of them, of a page in tiles. */
template <typename TPixel>
void
WriteTiles(TIFF * file, const TIFFRecipe & recipe, const std::vector<TPixel> & pixels, std::size_t samples, int plane)
{
  for (std::uint32_t y = 0; y < recipe.height; y += recipe.tileSize)
  {
    for (std::uint32_t x = 0; x < recipe.width; x += recipe.tileSize)
    {
      std::vector<TPixel> tile(recipe.tileSize * recipe.tileSize * samples);
      for (std::uint32_t j = 0; j < std::min(recipe.tileSize, recipe.height - y); ++j)
      {
        const auto row = pixels.begin() + static_cast<std::ptrdiff_t>(((y + j) * recipe.width + x) * samples);
        const auto columns = std::min(recipe.tileSize, recipe.width - x) * samples;
        std::copy(row,
                  row + static_cast<std::ptrdiff_t>(columns),
                  tile.begin() + static_cast<std::ptrdiff_t>(j * recipe.tileSize * samples));
      }
      TIFFWriteTile(file, tile.data(), x, y, 0, static_cast<std::uint16_t>(plane));
    }
  }
}

/** Writes pages of pixels, each sample of a planar page a page here. */
template <typename TPixel>
void
WriteTIFFPages(const std::string & path, const TIFFRecipe & recipe, const std::vector<std::vector<TPixel>> & pages)
{
  TIFF * const      file = TIFFOpen(path.c_str(), recipe.mode.c_str());
  const std::size_t planes = recipe.isPlanar ? static_cast<std::size_t>(recipe.samples) : 1;
  const std::size_t samples = recipe.isPlanar ? 1 : static_cast<std::size_t>(recipe.samples);
  for (std::size_t page = 0; page * planes < pages.size(); ++page)
  {
    SetTIFFTags<TPixel>(file, recipe, page == 0);
    if (page < recipe.numberOfPreviews)
    {
      TIFFSetField(file, TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE);
    }
    if (recipe.tileSize > 0)
    {
      TIFFSetField(file, TIFFTAG_TILEWIDTH, recipe.tileSize);
      TIFFSetField(file, TIFFTAG_TILELENGTH, recipe.tileSize);
    }
    else
    {
      TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, recipe.rowsPerStrip);
    }
    for (std::size_t plane = 0; plane < planes; ++plane)
    {
      std::vector<TPixel> pixels = pages[page * planes + plane];
      if (recipe.tileSize > 0)
      {
        WriteTiles(file, recipe, pixels, samples, static_cast<int>(plane));
        continue;
      }
      for (std::uint32_t y = 0; y < recipe.height; ++y)
      {
        TIFFWriteScanline(file, &pixels[y * recipe.width * samples], y, static_cast<std::uint16_t>(plane));
      }
    }
    TIFFWriteDirectory(file);
  }
  TIFFClose(file);
}

/** Writes pages whose pixels are those of MakePage(), the samples of planar pages one after another. */
template <typename TPixel>
void
WriteTIFF(const std::string & path, const TIFFRecipe & recipe, std::size_t numberOfPages)
{
  const auto                       samples = static_cast<std::size_t>(recipe.samples);
  std::vector<std::vector<TPixel>> pages;
  for (std::size_t page = 0; page < numberOfPages * (recipe.isPlanar ? samples : 1); ++page)
  {
    pages.push_back(MakePage<TPixel>(page, recipe.isPlanar ? 1 : samples));
  }
  WriteTIFFPages(path, recipe, pages);
}

/** The exception's words; empty where there is none. */
template <typename TWork>
std::string
WordsOf(const TWork & work)
{
  try
  {
    work();
  }
  catch (const itk::ExceptionObject & error)
  {
    return error.GetDescription();
  }
  catch (const std::exception & error)
  {
    return error.what();
  }
  return {};
}

template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
ReadStack(itk::ImageIOBase * io, const std::string & path)
{
  const auto reader = itk::ImageFileReader<itk::Image<TPixel, 3>>::New();
  reader->SetImageIO(io);
  reader->SetFileName(path);
  reader->Update();
  return reader->GetOutput();
}

inline void
ExpectSpacing(const itk::ImageBase<3> * image, const std::array<double, 3> & spacing)
{
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(image->GetSpacing()[axis], spacing[axis]) << "axis " << axis;
  }
}

/** The pixels of a slice. */
template <typename TPixel>
std::vector<TPixel>
SliceOf(const itk::Image<TPixel, 3> * image, std::size_t z)
{
  const auto   size = image->GetLargestPossibleRegion().GetSize();
  const auto * begin = image->GetBufferPointer() + z * size[0] * size[1];
  return { begin, begin + size[0] * size[1] };
}

#endif
