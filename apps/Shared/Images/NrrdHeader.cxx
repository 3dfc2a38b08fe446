/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/NrrdHeader.h"

#include "Shared/Images/HeaderLines.h"
#include "Shared/Images/VoxelFiles.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

namespace tissue
{
namespace
{
namespace fs = std::filesystem;

using Fields = std::map<std::string, std::string>;

const std::string dataFileField = "data file";
const std::string magic = "NRRD000";

std::string
ToLower(std::string text)
{
  std::transform(
    text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/** Throws where a line of a field is longer than the messages that the reader makes of it can be. */
void
RequireShortLine(const std::string & line, const std::string & name)
{
  static const std::set<std::string> texts{ "content", "labels", "units", "space units", "data file", "datafile" };
  static const std::set<std::string> numbers{ "sizes",      "spacings", "thicknesses",      "axis mins",    "axismins",
                                              "axis maxs",  "axismaxs", "space directions", "space origin", "kinds",
                                              "centerings", "centers",  "measurement frame" };
  constexpr std::size_t              longestText = 200;
  constexpr std::size_t              longestNumbers = 2000;
  const bool                         areNumbers = numbers.count(name) > 0;
  const std::size_t                  longest = areNumbers ? longestNumbers : longestText;
  const bool                         hasLongWord = areNumbers && [&line] {
    const std::vector<std::string> words = SplitWords(line);
    return std::any_of(words.begin(), words.end(), [](const std::string & word) { return word.size() > longestText; });
  }();
  if (texts.count(name) == 0 && (line.size() > longest || hasLongWord))
  {
    throw std::runtime_error("the header has the line '" + Shorten(line) + "' of " + std::to_string(line.size()) +
                             " characters, the format takes " + std::to_string(longest));
  }
}

/** Reads the fields up to the empty line or, of a list of files, up to the line that begins it. */
Fields
ReadFields(HeaderLines & lines)
{
  Fields      fields;
  std::string line;
  lines.Next(line);
  while (lines.Next(line) && !line.empty())
  {
    const std::size_t colon = line.find(':');
    if (line.front() == '#' || (colon != std::string::npos && line.compare(colon, 2, ":=") == 0))
    {
      continue;
    }
    std::string name = ToLower(line.substr(0, colon));
    RequireShortLine(line, name);
    if (colon == std::string::npos)
    {
      continue;
    }
    name = name == "datafile"   ? dataFileField
           : name == "lineskip" ? "line skip"
           : name == "byteskip" ? "byte skip"
                                : name;
    fields[name] = Trim(line.substr(colon + 1));
    if (name == dataFileField && fields[name].compare(0, 4, "LIST") == 0)
    {
      break;
    }
  }
  return fields;
}

std::string
ValueOf(const Fields & fields, const std::string & name, const std::string & otherwise)
{
  const auto field = fields.find(name);
  return field != fields.end() ? field->second : otherwise;
}

/** What is not known is left to the reader. */
std::uint64_t
BytesOf(const std::string & type)
{
  const auto has = [&type](const char * part) { return type.find(part) != std::string::npos; };
  if (has("long long") || has("64") || has("longlong") || has("double"))
  {
    return 8;
  }
  if (has("short") || has("16"))
  {
    return 2;
  }
  return has("int8") || has("char") ? 1 : has("int") || has("float") ? 4 : 1;
}

VoxelEncoding
EncodingOf(const std::string & name)
{
  if (name == "gz" || name == "gzip")
  {
    return VoxelEncoding::Compressed;
  }
  return name == "txt" || name == "text" || name == "ascii" ? VoxelEncoding::Text : VoxelEncoding::Raw;
}

std::vector<std::string>
ListNames(const std::string & value, HeaderLines & lines)
{
  std::vector<std::string> names;
  if (value.compare(0, 4, "LIST") == 0)
  {
    for (std::string line; lines.Next(line);)
    {
      line.empty() ? void() : names.push_back(line);
    }
    return names;
  }
  if (value.find('%') == std::string::npos)
  {
    return { value };
  }
  const std::vector<std::string> words = SplitWords(value);
  constexpr std::size_t          fewestWords = 4;
  if (words.size() < fewestWords)
  {
    throw std::runtime_error("the pattern of its files of voxels, '" + Shorten(value) +
                             "', must have behind it the first number, the last one and the step");
  }
  const std::vector<double> numbers = ReadNumbers(dataFileField, words[1] + " " + words[2] + " " + words[3], 3);
  return ExpandNumbers(words.front(), { numbers[0], numbers[1], numbers[2] });
}

/** Checks what is skipped of the voxels' files, and counts in what is sure. */
void
SkipBeforeVoxels(const Fields & fields, VoxelFiles & voxels)
{
  constexpr std::int64_t most = std::int64_t(1) << 50;
  // A byte skip of -1 stands for what is before the voxels at the end of the file.
  const std::int64_t bytes = ReadWholeNumbers("byte skip", ValueOf(fields, "byte skip", "0"), 1, -1, most).front();
  const std::int64_t rows = ReadWholeNumbers("line skip", ValueOf(fields, "line skip", "0"), 1, 0, most).front();
  // Bytes are skipped behind decompression, where there is one.
  if (voxels.encoding == VoxelEncoding::Raw)
  {
    voxels.skipped += static_cast<std::uint64_t>(std::max<std::int64_t>(bytes, 0) + rows);
  }
}
} // namespace

bool
IsNrrd(const std::string & path)
{
  std::string start(magic.size(), ' ');
  return std::ifstream(path, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size())) &&
         start == magic;
}

void
RequireSoundNrrd(const std::string & path)
{
  HeaderLines            lines(path);
  const Fields           fields = ReadFields(lines);
  constexpr std::int64_t mostDimensions = 16;
  constexpr std::int64_t longestAxis = std::int64_t(1) << 40;
  const std::int64_t     dimension =
    ReadWholeNumbers("dimension", ValueOf(fields, "dimension", ""), 1, 1, mostDimensions).front();
  const std::vector<std::int64_t> sizes =
    ReadWholeNumbers("sizes", ValueOf(fields, "sizes", ""), static_cast<std::size_t>(dimension), 1, longestAxis);
  VoxelFiles voxels;
  voxels.bytesOfNumber = BytesOf(ToLower(ValueOf(fields, "type", "")));
  for (const std::int64_t size : sizes)
  {
    voxels.Multiply(static_cast<std::uint64_t>(size));
  }
  const std::string encoding = ToLower(ValueOf(fields, "encoding", ""));
  voxels.encoding = EncodingOf(encoding);
  if (encoding == "hex")
  {
    voxels.Multiply(2);
  }
  SkipBeforeVoxels(fields, voxels);
  const auto dataFile = fields.find(dataFileField);
  if (dataFile == fields.end())
  {
    voxels.skipped += lines.GetOffset();
    voxels.files = { path };
  }
  else
  {
    for (const std::string & name : ListNames(dataFile->second, lines))
    {
      voxels.files.push_back(FindVoxelFile(path, name));
    }
  }
  if (encoding != "bz2" && encoding != "bzip2")
  {
    RequireVoxels(voxels);
  }
}
} // namespace tissue
