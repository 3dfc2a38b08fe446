/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/ImageDataFiles.h"

#include "itkStackHDF5ImageIO.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace tissue
{
namespace
{
namespace fs = std::filesystem;

std::string
ReadTrimmed(std::istream & stream)
{
  std::string line;
  std::getline(stream, line);
  line.erase(line.find_last_not_of(" \t\r") + 1);
  return line.erase(0, line.find_first_not_of(" \t"));
}

/** The files that "slice%03d.raw 1 20 1" stands for: a name, the first and last number, the step; or the name itself.
 */
std::vector<std::string>
ExpandPattern(const std::string & value)
{
  static const std::regex pattern(R"((.*)%(0?)(\d{0,2})d(\S*)\s+(\d{1,6})\s+(\d{1,6})\s+(\d{1,6}).*)");
  std::smatch             match;
  if (!std::regex_match(value, match, pattern))
  {
    return { value };
  }
  const std::size_t        width = match[3].length() > 0 ? std::stoul(match[3]) : 0;
  const char               fill = match[2].length() > 0 ? '0' : ' ';
  const long               last = std::stol(match[6]);
  const long               step = std::max(1L, std::stol(match[7]));
  std::vector<std::string> names;
  for (long i = std::stol(match[5]); i <= last; i += step)
  {
    const std::string number = std::to_string(i);
    names.push_back(match[1].str() + std::string(width - std::min(width, number.size()), fill) + number +
                    match[4].str());
  }
  return names;
}

/** By the line of a header that matches: what it captures, or the lines after it. */
std::vector<std::string>
ReadNames(std::istream & stream, const std::regex & key)
{
  constexpr std::size_t longestLine = 4096;
  std::smatch           match;
  for (std::string line = ReadTrimmed(stream); stream && !line.empty(); line = ReadTrimmed(stream))
  {
    // Regular expressions recurse; no header that is read has longer names.
    if (line.size() > longestLine || !std::regex_match(line, match, key))
    {
      continue;
    }
    const std::string value = match[1];
    if (value.compare(0, 4, "LIST") != 0)
    {
      return value == "LOCAL" ? std::vector<std::string>() : ExpandPattern(value);
    }
    std::vector<std::string> names;
    for (std::string name = ReadTrimmed(stream); !name.empty(); name = ReadTrimmed(stream))
    {
      names.push_back(name);
    }
    return names;
  }
  return {};
}

/** The other name of a pair: a.img of a.hdr, a.hdr.gz of a.img.gz. */
std::string
OtherOfPair(const std::string & path, const std::string & extension)
{
  std::string other = path;
  const auto  at = other.rfind(extension);
  return other.replace(at, extension.size(), extension == ".hdr" ? ".img" : ".hdr");
}
} // namespace

std::vector<std::string>
FindImageDataFiles(const std::string & header)
{
  static const std::regex meta(R"(ElementDataFile\s*=\s*(.+))");
  static const std::regex nrrd(R"(data ?file:\s*(.+))", std::regex::icase);
  const fs::path          path(header);
  const std::string       hdf5 = itk::StackHDF5ImageIO::SplitPath(header).first;
  if (hdf5 != header)
  {
    return { hdf5 };
  }
  const fs::path extension = path.extension() == ".gz" ? path.stem().extension() : path.extension();
  const bool     isMeta = extension == ".mhd" || extension == ".mha";
  if (extension == ".hdr" || extension == ".img")
  {
    return { OtherOfPair(header, extension.string()) };
  }
  if (!isMeta && extension != ".nhdr" && extension != ".nrrd")
  {
    return {};
  }
  std::ifstream            stream(header, std::ios::binary);
  std::vector<std::string> files;
  for (const std::string & name : ReadNames(stream, isMeta ? meta : nrrd))
  {
    files.push_back((path.parent_path() / name).string());
  }
  return files;
}
} // namespace tissue
