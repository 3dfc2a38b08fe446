/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkStackTIFFImageIO.h"

#include "LengthUnit.h"
#include "StackLayout.h"
#include "TIFFPages.h"

#include <tiff.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
using tissue::StackLayout;
using tissue::TIFFPageFormat;
using tissue::TIFFPages;

/** UNKNOWNCOMPONENTTYPE for a kind of number that is not read. */
IOComponentEnum
ToComponentType(const TIFFPageFormat & format)
{
  const unsigned int bits = std::max<unsigned int>(8, format.bits);
  if (format.bits > 8 && format.bits % 8 != 0)
  {
    return IOComponentEnum::UNKNOWNCOMPONENTTYPE;
  }
  const bool isFloat = format.sampleFormat == SAMPLEFORMAT_IEEEFP;
  const bool isSigned = format.sampleFormat == SAMPLEFORMAT_INT;
  if (isFloat)
  {
    return bits == 32   ? IOComponentEnum::FLOAT
           : bits == 64 ? IOComponentEnum::DOUBLE
                        : IOComponentEnum::UNKNOWNCOMPONENTTYPE;
  }
  if (format.sampleFormat != SAMPLEFORMAT_UINT && format.sampleFormat != SAMPLEFORMAT_VOID && !isSigned)
  {
    return IOComponentEnum::UNKNOWNCOMPONENTTYPE;
  }
  switch (bits)
  {
    case 8:
      return isSigned && format.bits == 8 ? IOComponentEnum::CHAR : IOComponentEnum::UCHAR;
    case 16:
      return isSigned ? IOComponentEnum::SHORT : IOComponentEnum::USHORT;
    case 32:
      return isSigned ? IOComponentEnum::INT : IOComponentEnum::UINT;
    case 64:
      return isSigned ? IOComponentEnum::LONGLONG : IOComponentEnum::ULONGLONG;
    default:
      return IOComponentEnum::UNKNOWNCOMPONENTTYPE;
  }
}

std::string
NameColors(std::uint16_t photometric)
{
  return photometric == PHOTOMETRIC_RGB || photometric == PHOTOMETRIC_YCBCR
           ? "RGB colours"
           : "colours of kind " + std::to_string(photometric) + " (photometric interpretation)";
}

/** Throws where the numbers of a page are no grey values, indices or labels. */
void
RequireNumbers(const TIFFPageFormat & format)
{
  const auto isOf = [&format](std::uint16_t photometric) { return format.photometric == photometric; };
  if (!isOf(PHOTOMETRIC_MINISBLACK) && !isOf(PHOTOMETRIC_MINISWHITE) && !isOf(PHOTOMETRIC_PALETTE) &&
      !isOf(PHOTOMETRIC_MASK))
  {
    throw std::runtime_error("the TIFF file has " + NameColors(format.photometric) +
                             ", an image of labels or of a stain has one number a voxel");
  }
  if (ToComponentType(format) == IOComponentEnum::UNKNOWNCOMPONENTTYPE)
  {
    throw std::runtime_error("the TIFF file has numbers of " + std::to_string(format.bits) + " bits and of kind " +
                             std::to_string(format.sampleFormat) + " (sample format), which are not read");
  }
}

std::string
Describe(const TIFFPageFormat & format)
{
  return std::to_string(format.width) + " x " + std::to_string(format.height) + " of " + std::to_string(format.bits) +
         " bits";
}

/** Throws where pages that are to be slices of one image are not alike, or are not there. */
void
RequirePages(const TIFFPages & pages, const StackLayout & layout)
{
  const TIFFPageFormat * first = nullptr;
  for (const std::ptrdiff_t page : layout.pages)
  {
    const auto index = static_cast<std::size_t>(page);
    if (page >= 0 && index >= pages.GetNumberOfPages())
    {
      throw std::runtime_error("the description of the TIFF file tells of " + std::to_string(layout.pages.size()) +
                               " planes, but the file has " + std::to_string(pages.GetNumberOfPages()) +
                               ": it is cut off, or the description is another file's");
    }
    if (page >= 0 && first == nullptr)
    {
      first = &pages.GetFormat(index);
      RequireNumbers(*first);
    }
    else if (page >= 0 && !(pages.GetFormat(index) == *first))
    {
      throw std::runtime_error("the pages of the TIFF file are not slices of one image: one is " + Describe(*first) +
                               ", page " + std::to_string(page + 1) + " is " + Describe(pages.GetFormat(index)));
    }
  }
}

/** The size of a voxel, and whether it is in micrometres. */
struct VoxelSize
{
  std::array<std::optional<double>, 3> lengths;
  bool                                 isInMicrometers = false;
  std::string                          warning;
};

/** A length that a file holds in single precision: without the digits that it does not tell. */
double
RoundToSingle(double length)
{
  const double scale = std::pow(10.0, 6.0 - std::floor(std::log10(length)));
  return std::round(length * scale) / scale;
}

/** Micrometres in the unit of the tags of resolution; nothing where there is no unit. */
std::optional<double>
UnitOfTags(const TIFFPages & pages, const StackLayout & layout)
{
  if (!layout.unit.empty())
  {
    return tissue::ToMicrometers(layout.unit);
  }
  const std::uint16_t unit = pages.GetResolutionUnit();
  return unit == RESUNIT_INCH         ? tissue::ToMicrometers("inch")
         : unit == RESUNIT_CENTIMETER ? tissue::ToMicrometers("cm")
                                      : std::nullopt;
}

/** A resolution that programs write for want of a better. */
bool
IsForPrint(double dotsPerInch)
{
  return dotsPerInch <= 1200.0 && dotsPerInch == std::floor(dotsPerInch);
}

VoxelSize
FindVoxelSize(const TIFFPages & pages, const StackLayout & layout)
{
  if (layout.voxelSize[0] || layout.voxelSize[1] || layout.voxelSize[2])
  {
    return { layout.voxelSize, true, {} };
  }
  const std::array<double, 2> & resolution = pages.GetResolution();
  const std::optional<double>   micrometers = UnitOfTags(pages, layout);
  const bool                    isOfITK = pages.GetSoftware() == "InsightToolkit";
  const bool                    isInch = micrometers && *micrometers == *tissue::ToMicrometers("inch");
  VoxelSize                     size;
  // ITK's numbers are taken for millimetres when they are made dots an inch.
  const double unit = isOfITK && isInch ? 25.4 : micrometers.value_or(1.0);
  if (layout.sliceDistance)
  {
    size.lengths[2] = *layout.sliceDistance * unit;
  }
  if (isInch && !isOfITK && IsForPrint(resolution[0]))
  {
    std::ostringstream text;
    text << "the TIFF file has a resolution for print, " << resolution[0] << " dots an inch, which is no voxel size";
    size.warning = resolution[0] > 1.0 ? text.str() : std::string();
    return size;
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double dots = resolution[axis] > 0.0 ? resolution[axis] : resolution[0];
    if (dots > 0.0 && (micrometers || dots != 1.0))
    {
      size.lengths[axis] = RoundToSingle(unit / dots);
    }
  }
  size.isInMicrometers = micrometers && !isOfITK && size.lengths[0];
  return size;
}
} // namespace

StackTIFFImageIO::StackTIFFImageIO()
{
  for (const char * extension : { ".tif", ".tiff", ".TIF", ".TIFF" })
  {
    this->AddSupportedReadExtension(extension);
  }
}

StackTIFFImageIO::~StackTIFFImageIO() = default;

bool
StackTIFFImageIO::CanReadFile(const char * path)
{
  // Zeiss' .lsm tells its channels in a way of its own.
  return std::filesystem::path(path).extension() != ".lsm" && TIFFPages::IsTIFF(path);
}

void
StackTIFFImageIO::ReadLayout()
{
  const std::string path = this->GetFileName();
  m_Pages = std::make_unique<TIFFPages>(path);
  const TIFFPageFormat & first = m_Pages->GetFormat(0);
  const bool             isGrey = first.photometric == PHOTOMETRIC_MINISBLACK;
  const auto             described = tissue::ReadStackLayout(m_Pages->GetDescription(),
                                                 { first.width, first.height, first.numberOfSamples },
                                                 std::filesystem::path(path).filename().string());
  const std::size_t      pages = m_Pages->GetNumberOfPages();
  m_Layout = std::make_unique<StackLayout>(described.value_or(tissue::MakeStackLayout({ { 'Z', pages } })));
  const std::size_t planes = m_Layout->pages.size();
  if (planes > 1 && pages == 1)
  {
    m_Pages->SplitSinglePage(planes);
  }
  RequirePages(*m_Pages, *m_Layout);
  if (described && planes < m_Pages->GetNumberOfPages() && m_Layout->warnings.empty())
  {
    this->AddWarning("the TIFF file has " + std::to_string(pages) + " pages, its description tells of " +
                     std::to_string(planes) + ", which are read");
  }
  // What several indices of one pixel would be nobody knows.
  if (!isGrey && first.numberOfSamples > 1)
  {
    throw std::runtime_error("the TIFF file has " + std::to_string(first.numberOfSamples) + " components a voxel");
  }
}

void
StackTIFFImageIO::ReadImageInformation()
{
  this->Reset();
  try
  {
    this->ReadLayout();
  }
  catch (const std::runtime_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
  const auto first = std::find_if(m_Layout->pages.begin(), m_Layout->pages.end(), [](auto page) { return page >= 0; });
  if (first == m_Layout->pages.end())
  {
    itkExceptionMacro("the OME-TIFF file holds none of the planes that it tells of: they are in other files");
  }
  if (m_Layout->numberOfSlices == 1 && m_Layout->numberOfFrames > 1)
  {
    itkExceptionMacro("the file has " << m_Layout->numberOfFrames
                                      << " frames of one slice each; if they are its slices, Fiji's Image > Properties "
                                         "exchanges the two numbers");
  }
  const TIFFPageFormat & format = m_Pages->GetFormat(static_cast<std::size_t>(*first));
  const VoxelSize        voxelSize = FindVoxelSize(*m_Pages, *m_Layout);
  this->SetByteOrder(IOByteOrderEnum::OrderNotApplicable);
  this->SetStack({ format.width, format.height, m_Layout->numberOfSlices },
                 voxelSize.lengths,
                 voxelSize.isInMicrometers,
                 ToComponentType(format));
  for (const std::string & warning : m_Layout->warnings)
  {
    this->AddWarning(warning);
  }
  if (!voxelSize.warning.empty())
  {
    this->AddWarning(voxelSize.warning);
  }
  this->RequireChoice(static_cast<unsigned int>(m_Layout->numberOfChannels * format.numberOfSamples),
                      static_cast<unsigned int>(m_Layout->numberOfFrames));
  for (std::size_t z = 0; z < m_Layout->numberOfSlices; ++z)
  {
    if (m_Layout->PageOf(this->ChosenChannel() / format.numberOfSamples, z, this->ChosenFrame()) < 0)
    {
      itkExceptionMacro("slice " << z + 1 << " of the OME-TIFF file is in another file of the set");
    }
  }
}

void
StackTIFFImageIO::Read(void * buffer)
{
  const ImageIORegion & region = this->GetIORegion();
  const auto            begin = [&region](unsigned int axis) {
    return axis < region.GetImageDimension() ? static_cast<std::size_t>(region.GetIndex(axis)) : 0;
  };
  const auto size = [&region](unsigned int axis) {
    return axis < region.GetImageDimension() ? static_cast<std::size_t>(region.GetSize(axis)) : 1;
  };
  const std::size_t bytes = this->GetComponentSize();
  const std::size_t width = this->GetDimensions(0);
  const std::size_t rowBytes = size(0) * bytes;
  std::vector<char> plane(width * this->GetDimensions(1) * bytes);
  char *            to = static_cast<char *>(buffer);
  for (std::size_t z = begin(2); z < begin(2) + size(2); ++z)
  {
    const std::size_t samples = m_Pages->GetFormat(0).numberOfSamples;
    const auto        page = m_Layout->PageOf(this->ChosenChannel() / samples, z, this->ChosenFrame());
    try
    {
      m_Pages->ReadPage(static_cast<std::size_t>(page), this->ChosenChannel() % samples, plane.data());
    }
    catch (const std::runtime_error & error)
    {
      itkExceptionMacro(<< error.what());
    }
    for (std::size_t y = begin(1); y < begin(1) + size(1); ++y, to += rowBytes)
    {
      std::memcpy(to, plane.data() + (y * width + begin(0)) * bytes, rowBytes);
    }
  }
}
} // namespace itk
