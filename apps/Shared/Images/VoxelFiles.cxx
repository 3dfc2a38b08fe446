/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/VoxelFiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tissue
{
namespace
{
namespace fs = std::filesystem;

constexpr std::uint64_t deflateRatio = 1032;

std::uint64_t
LeastBytesOf(const VoxelFiles & voxels)
{
  const std::uint64_t bytes = voxels.numbers * voxels.bytesOfNumber;
  switch (voxels.encoding)
  {
    case VoxelEncoding::Text:
      return 2 * voxels.numbers - 1;
    case VoxelEncoding::Compressed:
      return bytes / deflateRatio;
    default:
      return bytes;
  }
}

/** Whether a name stays in the folder that it begins in. */
bool
StaysInside(const fs::path & name)
{
  const fs::path normal = name.lexically_normal();
  return !normal.empty() && normal.is_relative() && *normal.begin() != "..";
}
} // namespace

void
VoxelFiles::Multiply(std::uint64_t size)
{
  constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
  if (size == 0 || numbers > most / 2 / size / std::max<std::uint64_t>(bytesOfNumber, 1))
  {
    throw std::runtime_error("the header promises more voxels than can be counted");
  }
  numbers *= size;
}

void
RequireVoxels(const VoxelFiles & voxels)
{
  std::uint64_t found = 0;
  for (const fs::path & file : voxels.files)
  {
    const std::uint64_t size = fs::file_size(file);
    found += size - std::min(size, voxels.skipped);
  }
  const std::uint64_t needed = LeastBytesOf(voxels);
  if (found < needed)
  {
    throw std::runtime_error("the file is cut off or broken: it holds " + std::to_string(found) +
                             " bytes of voxels, those of its header need at least " + std::to_string(needed));
  }
}

fs::path
FindVoxelFile(const fs::path & header, const std::string & name)
{
  constexpr std::size_t longest = 1023;
  if (name.empty() || name.size() > longest)
  {
    throw std::runtime_error("the name of its file of voxels has " + std::to_string(name.size()) +
                             " characters, must have 1 .. " + std::to_string(longest));
  }
  const fs::path folder = fs::absolute(header).parent_path();
  const fs::path given(name);
  const fs::path relative = given.is_absolute() ? given.lexically_relative(folder.lexically_normal()) : given;
  if (!StaysInside(relative))
  {
    throw std::runtime_error("its file of voxels, '" + Shorten(name) +
                             "', is not in the folder of the header; a link to it there is read");
  }
  fs::path        path = folder / relative;
  std::error_code error;
  if (!fs::is_regular_file(path, error))
  {
    throw std::runtime_error("its file of voxels, '" + Shorten(name) + "', " +
                             (fs::exists(path, error) ? "is not a regular file" : "is not there"));
  }
  if (fs::equivalent(path, header, error))
  {
    throw std::runtime_error("the header names itself as its file of voxels");
  }
  return path;
}

std::string
Shorten(const std::string & text)
{
  constexpr std::size_t longest = 60;
  std::string           part = text.substr(0, longest);
  const auto            isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  std::replace_if(part.begin(), part.end(), isControl, '?');
  return text.size() > longest ? part + "..." : part;
}

void
NumberRange::RequireBounded() const
{
  constexpr double most = 1e6;
  const double     steps = (last - first) / step;
  if (!(std::abs(first) <= 1e9 && std::abs(last) <= 1e9 && std::abs(step) >= 1.0 && steps >= 0.0 && steps < most))
  {
    throw std::runtime_error("the numbers of its files of voxels do not lead from the first to the last one");
  }
}

std::vector<std::string>
ExpandNumbers(const std::string & pattern, const NumberRange & range)
{
  const std::size_t percent = pattern.find('%');
  const std::size_t letter = pattern.find_first_not_of("0123456789", percent + 1);
  if (percent == std::string::npos || letter == std::string::npos || pattern[letter] != 'd' || letter > percent + 3 ||
      pattern.find('%', letter) != std::string::npos)
  {
    throw std::runtime_error("the pattern of its files of voxels, '" + Shorten(pattern) +
                             "', must have one number, as in slice%03d.raw");
  }
  range.RequireBounded();
  const std::string        digits = pattern.substr(percent + 1, letter - percent - 1);
  const std::size_t        width = digits.empty() ? 0 : std::stoul(digits);
  const char               fill = digits.rfind('0', 0) == 0 ? '0' : ' ';
  const auto               steps = static_cast<std::size_t>((range.last - range.first) / range.step);
  std::vector<std::string> names;
  for (std::size_t i = 0; i <= steps; ++i)
  {
    const std::string number = std::to_string(static_cast<long>(range.first + static_cast<double>(i) * range.step));
    names.push_back(pattern.substr(0, percent) + std::string(width - std::min(width, number.size()), fill) + number +
                    pattern.substr(letter + 1));
  }
  return names;
}
} // namespace tissue
