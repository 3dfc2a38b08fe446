/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkInrImageIO.h"

#include "itkByteSwapper.h"
#include "itk_zlib.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <sstream>

namespace itk
{
namespace
{
constexpr std::size_t blockSize = 256;
const std::string     magic = "#INRIMAGE-4#{";

/** A file, gzipped or not, that is read from its beginning on. */
class GzipStream
{
public:
  explicit GzipStream(const std::string & path)
    : m_File(gzopen(path.c_str(), "rb"), gzclose)
  {}

  /** Returns how many bytes there were. */
  std::size_t
  Read(char * bytes, std::size_t size)
  {
    constexpr std::size_t most = 1 << 30;
    std::size_t           total = 0;
    while (m_File && total < size)
    {
      const int read = gzread(m_File.get(), bytes + total, static_cast<unsigned int>(std::min(most, size - total)));
      if (read <= 0)
      {
        break;
      }
      total += static_cast<std::size_t>(read);
    }
    return total;
  }

private:
  // The closing function of a null pointer is not called.
  std::unique_ptr<gzFile_s, int (*)(gzFile)> m_File;
};

/** The header with its end; what there is of it where it has none. */
std::string
ReadHeader(GzipStream & stream)
{
  constexpr std::size_t most = 4096;
  std::string           header;
  for (std::size_t block = 0; block < most && header.find("##}") == std::string::npos; ++block)
  {
    char bytes[blockSize];
    header.append(bytes, stream.Read(bytes, blockSize));
    if (header.size() != (block + 1) * blockSize || header.compare(0, magic.size(), magic) != 0)
    {
      break;
    }
  }
  return header;
}

std::map<std::string, std::string>
ReadValues(const std::string & header)
{
  std::map<std::string, std::string> values;
  std::istringstream                 lines(header);
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos && line[0] != '#')
    {
      line.erase(line.find_last_not_of(" \t\r") + 1);
      values[line.substr(0, equals)] = line.substr(equals + 1);
    }
  }
  return values;
}

IOComponentEnum
ToComponentType(const std::string & type, const std::string & pixelSize)
{
  static const std::map<std::string, IOComponentEnum> types{
    { "unsigned fixed 8", IOComponentEnum::UCHAR },
    { "signed fixed 8", IOComponentEnum::CHAR },
    { "unsigned fixed 16", IOComponentEnum::USHORT },
    { "signed fixed 16", IOComponentEnum::SHORT },
    { "unsigned fixed 32", IOComponentEnum::UINT },
    { "signed fixed 32", IOComponentEnum::INT },
    { "unsigned fixed 64", IOComponentEnum::ULONGLONG },
    { "signed fixed 64", IOComponentEnum::LONGLONG },
    { "float 32", IOComponentEnum::FLOAT },
    { "float 64", IOComponentEnum::DOUBLE },
  };
  // "16 bits", or "8+8+8 bits" of several components.
  const auto found = types.find(type + " " + pixelSize.substr(0, pixelSize.find_first_of(" +")));
  return found != types.end() ? found->second : IOComponentEnum::UNKNOWNCOMPONENTTYPE;
}

void
SwapBytes(char * bytes, std::size_t size, std::size_t bytesOfPixel)
{
  for (std::size_t i = 0; i + bytesOfPixel <= size; i += bytesOfPixel)
  {
    std::reverse(bytes + i, bytes + i + bytesOfPixel);
  }
}
} // namespace

InrImageIO::InrImageIO()
{
  this->AddSupportedReadExtension(".inr");
  this->AddSupportedReadExtension(".inr.gz");
}

bool
InrImageIO::CanReadFile(const char * path)
{
  std::string start(magic.size(), ' ');
  return GzipStream(path).Read(start.data(), start.size()) == magic.size() && start == magic;
}

void
InrImageIO::ReadImageInformation()
{
  this->Reset();
  GzipStream        stream(this->GetFileName());
  const std::string header = ReadHeader(stream);
  if (header.find("##}") == std::string::npos)
  {
    itkExceptionMacro("the file is cut off or broken: the header of Inrimage has no end");
  }
  m_HeaderSize = header.size();
  const auto values = ReadValues(header);
  const auto text = [&values](const std::string & name) {
    const auto found = values.find(name);
    return found != values.end() ? found->second : std::string();
  };
  const auto number = [&](const std::string & name) { return std::strtod(text(name).c_str(), nullptr); };
  std::array<SizeValueType, 3>         size{};
  std::array<std::optional<double>, 3> voxelSize;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const std::string name(1, "XYZ"[axis]);
    const double      extent = number(name + "DIM");
    if (!(extent >= 1.0 && extent < 1e6))
    {
      itkExceptionMacro("the header of Inrimage has no " << name << "DIM above 0 and below 1000000");
    }
    size[axis] = static_cast<SizeValueType>(extent);
    voxelSize[axis] = number("V" + name);
  }
  const IOComponentEnum type = ToComponentType(text("TYPE"), text("PIXSIZE"));
  if (type == IOComponentEnum::UNKNOWNCOMPONENTTYPE)
  {
    itkExceptionMacro("the header of Inrimage has TYPE=" << text("TYPE") << " and PIXSIZE=" << text("PIXSIZE")
                                                         << ", which are not read");
  }
  const std::string cpu = text("CPU");
  const bool        isBig = cpu == "sun" || cpu == "sgi";
  this->SetByteOrder(isBig ? IOByteOrderEnum::BigEndian : IOByteOrderEnum::LittleEndian);
  this->SetStack(size, voxelSize, true, type);
  this->RequireChoice(static_cast<unsigned int>(std::clamp(number("VDIM"), 1.0, 1e6)), 1);
}

void
InrImageIO::Read(void * buffer)
{
  const std::size_t bytes = this->GetComponentSize();
  const std::size_t channels = this->GetNumberOfChannels();
  const bool        isForeign =
    ByteSwapper<short>::SystemIsBigEndian() != (this->GetByteOrder() == IOByteOrderEnum::BigEndian);
  const ImageIORegion & region = this->GetIORegion();
  const auto            isIn = [&region](unsigned int axis, std::size_t index) {
    const auto begin = axis < region.GetImageDimension() ? static_cast<std::size_t>(region.GetIndex(axis)) : 0;
    const auto size = axis < region.GetImageDimension() ? static_cast<std::size_t>(region.GetSize(axis)) : 1;
    return index >= begin && index < begin + size;
  };
  GzipStream        stream(this->GetFileName());
  std::vector<char> skipped(m_HeaderSize);
  stream.Read(skipped.data(), skipped.size());
  std::vector<char> row(this->GetDimensions(0) * channels * bytes);
  char *            to = static_cast<char *>(buffer);
  for (std::size_t z = 0; z < this->GetDimensions(2); ++z)
  {
    for (std::size_t y = 0; y < this->GetDimensions(1); ++y)
    {
      if (stream.Read(row.data(), row.size()) != row.size())
      {
        itkExceptionMacro("the file is cut off or broken: it ends in slice " << z + 1 << " of "
                                                                             << this->GetDimensions(2));
      }
      for (std::size_t x = 0; isIn(2, z) && isIn(1, y) && x < this->GetDimensions(0); ++x)
      {
        if (isIn(0, x))
        {
          std::memcpy(to, row.data() + (x * channels + this->ChosenChannel()) * bytes, bytes);
          isForeign ? SwapBytes(to, bytes, bytes) : void();
          to += bytes;
        }
      }
    }
  }
}
} // namespace itk
