/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/MetaImageHeader.h"

#include "Shared/Images/HeaderLines.h"
#include "Shared/Images/VoxelFiles.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>

namespace tissue
{
namespace
{
namespace fs = std::filesystem;

using Fields = std::map<std::string, std::string>;

constexpr std::int64_t mostDimensions = 10;

/** Reads the fields up to ElementDataFile. */
Fields
ReadFields(HeaderLines & lines)
{
  constexpr std::size_t longestName = 254;
  constexpr std::size_t longestValue = 8191;
  Fields                fields;
  std::string           line;
  while (fields.count("ElementDataFile") == 0)
  {
    if (!lines.Next(line))
    {
      throw std::runtime_error("the header has no ElementDataFile");
    }
    if (line.empty())
    {
      continue;
    }
    const std::size_t separator = line.find_first_of("=:");
    if (separator == std::string::npos || separator == 0 || separator > longestName ||
        line.size() - separator > longestValue)
    {
      throw std::runtime_error("the header has the line '" + Shorten(line) + "', a line is NAME = VALUE, of " +
                               std::to_string(longestName) + " and " + std::to_string(longestValue) +
                               " characters at most");
    }
    const std::string name = Trim(line.substr(0, separator));
    // Any number of separators.
    const std::size_t value = line.find_first_not_of("=: \t", separator);
    fields[name] = value == std::string::npos ? "" : line.substr(value);
    if (fields[name].empty())
    {
      throw std::runtime_error("the header has no value of " + Shorten(name));
    }
  }
  return fields;
}

std::string
ValueOf(const Fields & fields, const std::string & name)
{
  const auto field = fields.find(name);
  if (field == fields.end())
  {
    throw std::runtime_error("the header has no " + name);
  }
  return field->second;
}

bool
IsTrue(const Fields & fields, const std::string & name, bool otherwise)
{
  const auto field = fields.find(name);
  return field == fields.end() ? otherwise : std::string("Tt1").find(field->second.front()) != std::string::npos;
}

VoxelEncoding
EncodingOf(const Fields & fields)
{
  if (IsTrue(fields, "CompressedData", false))
  {
    return VoxelEncoding::Compressed;
  }
  return IsTrue(fields, "BinaryData", true) ? VoxelEncoding::Raw : VoxelEncoding::Text;
}

/** MetaIO has an array of 255 characters for each of these. */
void
RequireShortTexts(const Fields & fields)
{
  for (const auto & [name, longest] : std::map<std::string, std::size_t>{ { "Comment", 254 },
                                                                          { "ObjectType", 254 },
                                                                          { "ObjectSubType", 254 },
                                                                          { "Name", 254 },
                                                                          { "AcquisitionDate", 254 },
                                                                          { "Modality", 254 },
                                                                          { "DistanceUnits", 254 },
                                                                          { "ElementType", 254 },
                                                                          { "AnatomicalOrientation", 9 } })
  {
    const auto field = fields.find(name);
    if (field != fields.end() && field->second.size() > longest)
    {
      throw std::runtime_error("the header has a " + name + " of " + std::to_string(field->second.size()) +
                               " characters, the format takes " + std::to_string(longest));
    }
  }
}

void
RequireNumbers(const Fields & fields, std::size_t dimensions)
{
  const std::map<std::string, std::size_t> counts{ { "ElementSpacing", dimensions },
                                                   { "ElementSize", dimensions },
                                                   { "Offset", dimensions },
                                                   { "Position", dimensions },
                                                   { "Origin", dimensions },
                                                   { "CenterOfRotation", dimensions },
                                                   { "SequenceID", dimensions },
                                                   { "TransformMatrix", dimensions * dimensions },
                                                   { "Rotation", dimensions * dimensions },
                                                   { "Orientation", dimensions * dimensions },
                                                   { "Color", 4 },
                                                   { "ID", 1 },
                                                   { "ParentID", 1 },
                                                   { "ElementMin", 1 },
                                                   { "ElementMax", 1 },
                                                   { "ElementToIntensityFunctionSlope", 1 },
                                                   { "ElementToIntensityFunctionOffset", 1 } };
  // What is behind the numbers goes into an array of this length.
  constexpr std::size_t longest = 499;
  for (const auto & [name, count] : counts)
  {
    const auto field = fields.find(name);
    if (field != fields.end() && ReadNumbers(name, field->second, count).size() > count &&
        field->second.size() > longest)
    {
      throw std::runtime_error("the header has more than " + std::to_string(count) + " numbers of " + name);
    }
  }
}

/** Bytes in the file: what is not known is left to MetaIO. */
std::uint64_t
BytesOf(const std::string & type)
{
  static const std::map<std::string, std::uint64_t> bytes{
    { "MET_SHORT", 2 }, { "MET_USHORT", 2 },    { "MET_INT", 4 },   { "MET_UINT", 4 },   { "MET_LONG", 4 },
    { "MET_ULONG", 4 }, { "MET_LONG_LONG", 8 }, { "MET_FLOAT", 4 }, { "MET_DOUBLE", 8 }, { "MET_ULONG_LONG", 8 }
  };
  const auto found = bytes.find(type.substr(0, type.find("_ARRAY")));
  return found != bytes.end() ? found->second : 1;
}

std::vector<fs::path>
ListFiles(const std::string & path, const std::string & value, HeaderLines & lines)
{
  std::vector<std::string>       names{ value };
  const std::vector<std::string> words = SplitWords(value);
  constexpr std::size_t          longestWord = 79;
  if (words.front() == "LIST")
  {
    names.clear();
    for (std::string line; lines.Next(line);)
    {
      line.empty() ? void() : names.push_back(line);
    }
  }
  else if (value.find('%') != std::string::npos)
  {
    if (words.size() != 4 || words.front().size() > longestWord)
    {
      throw std::runtime_error("the pattern of its files of voxels, '" + Shorten(value) + "', must have at most " +
                               std::to_string(longestWord) +
                               " characters, and behind it the first number, the last one and the step");
    }
    constexpr std::int64_t          most = std::numeric_limits<int>::max();
    const std::string               text = words[1] + " " + words[2] + " " + words[3];
    const std::vector<std::int64_t> numbers = ReadWholeNumbers("ElementDataFile", text, 3, 0, most);
    names = ExpandNumbers(
      words.front(),
      { static_cast<double>(numbers[0]), static_cast<double>(numbers[1]), static_cast<double>(numbers[2]) });
  }
  std::vector<fs::path> files;
  for (const std::string & name : names)
  {
    if (names.size() > 1 && name.find('%') != std::string::npos)
    {
      throw std::runtime_error("its list has the file of voxels '" + Shorten(name) + "', which is a pattern");
    }
    files.push_back(FindVoxelFile(path, name));
  }
  return files;
}

/** MetaIO takes as much memory as is said, whatever there is. */
void
RequireCompressedSize(const Fields & fields, const std::vector<fs::path> & files)
{
  const auto field = fields.find("CompressedDataSize");
  if (field != fields.end() && !files.empty())
  {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    const std::int64_t     size = ReadWholeNumbers(field->first, field->second, 1, 0, most).front();
    const auto             found = static_cast<std::int64_t>(fs::file_size(files.front()));
    if (size > found)
    {
      throw std::runtime_error("the file is cut off or broken: it holds " + std::to_string(found) +
                               " bytes, its header has CompressedDataSize = " + std::to_string(size));
    }
  }
}
} // namespace

bool
IsMetaImage(const std::string & path)
{
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  if (extension != ".mha" && extension != ".mhd")
  {
    return false;
  }
  HeaderLines lines(path);
  std::string line;
  for (bool isThere = true; isThere && line.empty();)
  {
    isThere = lines.Next(line);
  }
  const std::string first = line.substr(0, line.find_first_of(" \t=:"));
  const auto        begins = [&first](const char * name) { return first.find(name) != std::string::npos; };
  return line.find_first_of("=:") != std::string::npos || begins("ObjectType") || begins("Type") || begins("ID") ||
         begins("BinaryData") || begins("Comment") || begins("AcquisitionDate") || begins("Modality");
}

void
RequireSoundMetaImage(const std::string & path)
{
  HeaderLines  lines(path);
  const Fields fields = ReadFields(lines);
  const auto   dimensions =
    static_cast<std::size_t>(ReadWholeNumbers("NDims", ValueOf(fields, "NDims"), 1, 1, mostDimensions).front());
  RequireShortTexts(fields);
  RequireNumbers(fields, dimensions);

  constexpr std::int64_t          most = std::numeric_limits<int>::max();
  const std::vector<std::int64_t> sizes = ReadWholeNumbers("DimSize", ValueOf(fields, "DimSize"), dimensions, 1, most);
  VoxelFiles                      voxels;
  voxels.bytesOfNumber = BytesOf(ValueOf(fields, "ElementType"));
  for (std::size_t axis = 0; axis < dimensions; ++axis)
  {
    voxels.Multiply(static_cast<std::uint64_t>(sizes[axis]));
  }
  constexpr std::int64_t mostChannels = 65536;
  const auto             channels = fields.find("ElementNumberOfChannels");
  if (channels != fields.end())
  {
    voxels.Multiply(
      static_cast<std::uint64_t>(ReadWholeNumbers(channels->first, channels->second, 1, 1, mostChannels).front()));
  }
  voxels.encoding = EncodingOf(fields);
  const std::string dataFile = fields.at("ElementDataFile");
  const auto        headerSize = fields.find("HeaderSize");
  if (headerSize != fields.end())
  {
    const std::int64_t skipped =
      ReadWholeNumbers("HeaderSize", headerSize->second, 1, -1, std::int64_t(1) << 50).front();
    voxels.skipped = static_cast<std::uint64_t>(std::max<std::int64_t>(skipped, 0));
  }
  if (dataFile == "LOCAL" || dataFile == "Local" || dataFile == "local")
  {
    voxels.skipped += lines.GetOffset();
    voxels.files = { path };
  }
  else
  {
    voxels.files = ListFiles(path, dataFile, lines);
  }
  RequireCompressedSize(fields, voxels.files);
  RequireVoxels(voxels);
}
} // namespace tissue
