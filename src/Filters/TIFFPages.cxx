/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TIFFPages.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <tuple>

namespace tissue
{
namespace
{
extern "C" int
KeepError(TIFF *, void * text, const char *, const char * format, va_list arguments)
{
  char buffer[512];
  std::vsnprintf(buffer, sizeof(buffer), format, arguments);
  *static_cast<std::string *>(text) = buffer;
  return 1;
}

extern "C" int
DropWarning(TIFF *, void *, const char *, const char *, va_list)
{
  return 1;
}

template <typename TValue>
TValue
GetTag(TIFF * file, std::uint32_t tag, TValue value)
{
  TIFFGetFieldDefaulted(file, tag, &value);
  return value;
}

std::string
GetText(TIFF * file, std::uint32_t tag)
{
  const char * text = nullptr;
  return TIFFGetField(file, tag, &text) == 1 && text != nullptr ? text : "";
}

TIFFPageFormat
GetPageFormat(TIFF * file)
{
  TIFFPageFormat format;
  format.width = GetTag(file, TIFFTAG_IMAGEWIDTH, format.width);
  format.height = GetTag(file, TIFFTAG_IMAGELENGTH, format.height);
  format.bits = GetTag(file, TIFFTAG_BITSPERSAMPLE, format.bits);
  format.sampleFormat = GetTag(file, TIFFTAG_SAMPLEFORMAT, format.sampleFormat);
  format.numberOfSamples = GetTag(file, TIFFTAG_SAMPLESPERPIXEL, format.numberOfSamples);
  format.photometric = GetTag(file, TIFFTAG_PHOTOMETRIC, format.photometric);
  format.isPlanar = GetTag(file, TIFFTAG_PLANARCONFIG, std::uint16_t{ PLANARCONFIG_CONTIG }) == PLANARCONFIG_SEPARATE &&
                    format.numberOfSamples > 1;
  return format;
}

/** How the pixels of a decoded strip or tile lie. */
struct Row
{
  std::size_t bits;
  std::size_t samplesInRow;
  std::size_t sample;
};

/** Copies one sample of the pixels of a row, unpacked. */
void
CopyRow(const unsigned char * from, std::size_t numberOfPixels, const Row & row, char * to)
{
  if (row.bits < 8)
  {
    for (std::size_t i = 0; i < numberOfPixels; ++i)
    {
      const std::size_t bit = (i * row.samplesInRow + row.sample) * row.bits;
      to[i] = static_cast<char>((from[bit / 8] >> (8 - row.bits - bit % 8)) & ((1u << row.bits) - 1));
    }
    return;
  }
  const std::size_t bytes = row.bits / 8;
  if (row.samplesInRow == 1)
  {
    std::memcpy(to, from, numberOfPixels * bytes);
    return;
  }
  for (std::size_t i = 0; i < numberOfPixels; ++i)
  {
    std::memcpy(to + i * bytes, from + (i * row.samplesInRow + row.sample) * bytes, bytes);
  }
}

std::size_t
BytesOfPixel(const TIFFPageFormat & format)
{
  return std::max<std::size_t>(1, format.bits / 8);
}

Row
RowOf(const TIFFPageFormat & format, std::size_t sample)
{
  return format.isPlanar ? Row{ format.bits, 1, 0 } : Row{ format.bits, format.numberOfSamples, sample };
}
} // namespace

struct TIFFPages::Handle
{
  TIFF *      file = nullptr;
  std::string error;

  ~Handle()
  {
    if (file != nullptr)
    {
      TIFFClose(file);
    }
  }
};

bool
TIFFPageFormat::operator==(const TIFFPageFormat & other) const
{
  const auto all = [](const TIFFPageFormat & f) {
    return std::tie(f.width, f.height, f.bits, f.sampleFormat, f.numberOfSamples, f.photometric, f.isPlanar);
  };
  return all(*this) == all(other);
}

TIFFPages::TIFFPages(const std::string & path)
  : m_Path(path)
  , m_Handle(std::make_unique<Handle>())
{
  TIFFOpenOptions * const options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, KeepError, &m_Handle->error);
  TIFFOpenOptionsSetWarningHandlerExtR(options, DropWarning, nullptr);
  m_Handle->file = TIFFOpenExt(path.c_str(), "r", options);
  TIFFOpenOptionsFree(options);
  if (m_Handle->file == nullptr)
  {
    this->Fail("the file is cut off or broken");
  }
  this->ReadDirectories();
  TIFFSetSubDirectory(m_Handle->file, m_Pages.front().offset);
  this->ReadFirstTags();
}

TIFFPages::~TIFFPages() = default;

bool
TIFFPages::IsTIFF(const std::string & path)
{
  std::ifstream stream(path, std::ios::binary);
  char          bytes[4] = {};
  stream.read(bytes, sizeof(bytes));
  const std::string magic(bytes, sizeof(bytes));
  const auto        is = [&magic](const char(&text)[5]) { return magic == std::string(text, 4); };
  return stream && (is("II*\0") || is("MM\0*") || is("II+\0") || is("MM\0+"));
}

void
TIFFPages::Fail(const std::string & what) const
{
  throw std::runtime_error(what + (m_Handle->error.empty() ? "" : ": " + m_Handle->error));
}

void
TIFFPages::ReadDirectories()
{
  TIFF * const      file = m_Handle->file;
  std::vector<Page> reduced;
  do
  {
    const Page page{ TIFFCurrentDirOffset(file), GetPageFormat(file) };
    const bool isReduced = (GetTag(file, TIFFTAG_SUBFILETYPE, std::uint32_t{ 0 }) & FILETYPE_REDUCEDIMAGE) != 0;
    (isReduced ? reduced : m_Pages).push_back(page);
    if (page.format.width == 0 || page.format.height == 0 || GetTag(file, TIFFTAG_IMAGEDEPTH, std::uint32_t{ 1 }) > 1)
    {
      this->Fail("page " + std::to_string(m_Pages.size()) + " of the TIFF file is no plane of pixels");
    }
  } while (TIFFReadDirectory(file) == 1);
  if (!TIFFLastDirectory(file) || !m_Handle->error.empty())
  {
    this->Fail("the file is cut off or broken");
  }
  m_Pages = m_Pages.empty() ? reduced : m_Pages;
}

void
TIFFPages::ReadFirstTags()
{
  TIFF * const file = m_Handle->file;
  m_Description = GetText(file, TIFFTAG_IMAGEDESCRIPTION);
  m_Software = GetText(file, TIFFTAG_SOFTWARE);
  const std::uint32_t tags[] = { TIFFTAG_XRESOLUTION, TIFFTAG_YRESOLUTION };
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    float value = 0.0f;
    m_Resolution[axis] = TIFFGetField(file, tags[axis], &value) == 1 && value > 0.0f ? value : 0.0;
  }
  m_ResolutionUnit = GetTag(file, TIFFTAG_RESOLUTIONUNIT, m_ResolutionUnit);
}

bool
TIFFPages::SplitSinglePage(std::size_t numberOfPages)
{
  TIFF * const           file = m_Handle->file;
  const TIFFPageFormat & format = m_Pages.front().format;
  if (m_Pages.size() != 1 || TIFFIsTiled(file) || format.numberOfSamples != 1 || format.bits % 8 != 0 ||
      GetTag(file, TIFFTAG_COMPRESSION, std::uint16_t{ COMPRESSION_NONE }) != COMPRESSION_NONE)
  {
    return false;
  }
  const std::uint64_t bytes = std::uint64_t{ format.width } * format.height * BytesOfPixel(format);
  const std::uint64_t offset = TIFFGetStrileOffset(file, 0);
  for (std::uint32_t strip = 1; strip < TIFFNumberOfStrips(file); ++strip)
  {
    if (TIFFGetStrileOffset(file, strip) !=
        TIFFGetStrileOffset(file, strip - 1) + TIFFGetStrileByteCount(file, strip - 1))
    {
      return false;
    }
  }
  const std::uint64_t fileSize = std::filesystem::file_size(m_Path);
  if (offset == 0 || fileSize < offset || (fileSize - offset) / bytes < numberOfPages)
  {
    return false;
  }
  m_RawOffset = offset;
  m_Pages.assign(numberOfPages, Page(m_Pages.front()));
  return true;
}

void
TIFFPages::ReadPage(std::size_t page, std::size_t sample, char * pixels)
{
  if (m_RawOffset > 0)
  {
    this->ReadRaw(page, pixels);
    return;
  }
  m_Handle->error.clear();
  TIFF * const           file = m_Handle->file;
  const TIFFPageFormat & format = m_Pages[page].format;
  if (TIFFSetSubDirectory(file, m_Pages[page].offset) != 1)
  {
    this->Fail("page " + std::to_string(page + 1) + " of the TIFF file cannot be read");
  }
  const auto compression = GetTag(file, TIFFTAG_COMPRESSION, std::uint16_t{ COMPRESSION_NONE });
  if (TIFFIsCODECConfigured(compression) != 1)
  {
    this->Fail("libtiff does not know the compression " + std::to_string(compression) + " of the TIFF file");
  }
  try
  {
    TIFFIsTiled(file) ? this->ReadTiles(format, sample, pixels) : this->ReadStrips(format, sample, pixels);
  }
  catch (const std::runtime_error & error)
  {
    throw std::runtime_error("page " + std::to_string(page + 1) +
                             " of the TIFF file, which is cut off or broken: " + error.what());
  }
}

void
TIFFPages::ReadTiles(const TIFFPageFormat & format, std::size_t sample, char * pixels)
{
  TIFF * const               file = m_Handle->file;
  const auto                 width = GetTag(file, TIFFTAG_TILEWIDTH, std::uint32_t{ 0 });
  const auto                 height = GetTag(file, TIFFTAG_TILELENGTH, std::uint32_t{ 0 });
  const auto                 rowBytes = static_cast<std::size_t>(TIFFTileRowSize(file));
  const Row                  row = RowOf(format, sample);
  std::vector<unsigned char> tile(static_cast<std::size_t>(TIFFTileSize(file)));
  for (std::uint32_t y = 0; y < format.height; y += height)
  {
    for (std::uint32_t x = 0; x < format.width; x += width)
    {
      const auto index = TIFFComputeTile(file, x, y, 0, static_cast<std::uint16_t>(format.isPlanar ? sample : 0));
      const auto size = static_cast<tmsize_t>(tile.size());
      if (TIFFReadEncodedTile(file, index, tile.data(), size) != size)
      {
        this->Fail("tile " + std::to_string(index));
      }
      const std::uint32_t columns = std::min(width, format.width - x);
      for (std::uint32_t j = 0; j < std::min(height, format.height - y); ++j)
      {
        const std::size_t to = (std::size_t{ y } + j) * format.width + x;
        CopyRow(tile.data() + j * rowBytes, columns, row, pixels + to * BytesOfPixel(format));
      }
    }
  }
}

void
TIFFPages::ReadStrips(const TIFFPageFormat & format, std::size_t sample, char * pixels)
{
  TIFF * const               file = m_Handle->file;
  const auto                 height = std::min(GetTag(file, TIFFTAG_ROWSPERSTRIP, format.height), format.height);
  const auto                 rowBytes = static_cast<std::size_t>(TIFFScanlineSize(file));
  const Row                  row = RowOf(format, sample);
  std::vector<unsigned char> strip(rowBytes * height);
  for (std::uint32_t y = 0; y < format.height; y += height)
  {
    const auto          index = TIFFComputeStrip(file, y, static_cast<std::uint16_t>(format.isPlanar ? sample : 0));
    const std::uint32_t rows = std::min(height, format.height - y);
    const auto          size = static_cast<tmsize_t>(rows * rowBytes);
    if (TIFFReadEncodedStrip(file, index, strip.data(), size) != size)
    {
      this->Fail("strip " + std::to_string(index));
    }
    for (std::uint32_t j = 0; j < rows; ++j)
    {
      char * const to = pixels + (std::size_t{ y } + j) * format.width * BytesOfPixel(format);
      CopyRow(strip.data() + j * rowBytes, format.width, row, to);
    }
  }
}

void
TIFFPages::ReadRaw(std::size_t page, char * pixels)
{
  const TIFFPageFormat & format = m_Pages[page].format;
  const std::size_t      bytesOfPixel = BytesOfPixel(format);
  const std::size_t      bytes = std::size_t{ format.width } * format.height * bytesOfPixel;
  std::ifstream          stream(m_Path, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(m_RawOffset + page * std::uint64_t{ bytes }));
  if (!stream.read(pixels, static_cast<std::streamsize>(bytes)))
  {
    throw std::runtime_error("plane " + std::to_string(page + 1) + " of the TIFF file cannot be read");
  }
  if (TIFFIsByteSwapped(m_Handle->file))
  {
    for (std::size_t i = 0; i < bytes; i += bytesOfPixel)
    {
      std::reverse(pixels + i, pixels + i + bytesOfPixel);
    }
  }
}
} // namespace tissue
