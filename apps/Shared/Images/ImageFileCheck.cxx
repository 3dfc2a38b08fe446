/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/ImageFileCheck.h"

#include "Shared/Images/ChosenStackImageIO.h"

#include <itkMetaDataObject.h>
#include <itk_zlib.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
/** Bytes in the file, decompressed if it is gzipped; those before the break if it is broken. */
std::uint64_t
CountBytes(const std::string & path)
{
  const std::filesystem::path file(path);
  if (file.extension() != ".gz")
  {
    return std::filesystem::file_size(file);
  }
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> stream(gzopen(path.c_str(), "rb"), gzclose);
  std::vector<char>                                buffer(1 << 20);
  std::uint64_t                                    total = 0;
  for (int size = 1; stream && size > 0; total += size > 0 ? size : 0)
  {
    size = gzread(stream.get(), buffer.data(), static_cast<unsigned int>(buffer.size()));
  }
  return total;
}
/** Bytes of the voxels in the file: a scaled image of NIfTI holds integers where its header promises floats. */
std::uint64_t
CountNeededBytes(const itk::ImageIOBase * io)
{
  const auto  bytes = static_cast<std::uint64_t>(io->GetImageSizeInBytes());
  std::string bits;
  return io->GetNameOfClass() == std::string("NiftiImageIO") &&
             itk::ExposeMetaData<std::string>(io->GetMetaDataDictionary(), "bitpix", bits)
           ? bytes / (io->GetComponentSize() * io->GetNumberOfComponents()) * std::stoul(bits) / 8
           : bytes;
}
} // namespace

void
RequireAllVoxels(const std::string & path, const itk::ImageIOBase * image)
{
  const itk::ImageIOBase * const                    io = SourceOf(image);
  static const std::map<std::string, std::uint64_t> leastHeaders{
    { "NiftiImageIO", 352 }, { "GiplImageIO", 256 }, { "MRCImageIO", 1024 }, { "VTKImageIO", 0 }
  };
  const auto header = leastHeaders.find(io->GetNameOfClass());
  const bool isOfTwoFiles = path.find(".hdr") != std::string::npos || path.find(".img") != std::string::npos;
  if (header == leastHeaders.end() || isOfTwoFiles || io->GetFileType() == itk::IOFileEnum::ASCII)
  {
    return;
  }
  const std::uint64_t needed = header->second + CountNeededBytes(io);
  const std::uint64_t found = CountBytes(path);
  if (found < needed)
  {
    throw std::runtime_error("the file is cut off: it holds " + std::to_string(found) + " bytes, its header and " +
                             "voxels need at least " + std::to_string(needed));
  }
}

std::vector<std::string>
JudgeMessages(const std::string & messages, const itk::ImageIOBase * io)
{
  const std::string        format = SourceOf(io)->GetNameOfClass();
  const bool               speaksOfErrors = format == "MetaImageIO" || format == "TIFFImageIO";
  std::vector<std::string> warnings;
  std::istringstream       lines(messages);
  for (std::string line; std::getline(lines, line);)
  {
    const bool isWarning = !speaksOfErrors || line.find("arning") != std::string::npos;
    if (!isWarning && !line.empty())
    {
      throw std::runtime_error("the file is cut off or broken: " + messages);
    }
    if (!line.empty())
    {
      warnings.push_back(line);
    }
  }
  return warnings;
}
} // namespace tissue
