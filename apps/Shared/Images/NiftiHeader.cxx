/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/NiftiHeader.h"

#include <itk_zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tissue
{
namespace
{
constexpr std::int32_t headerSize = 348;

using Header = std::array<char, headerSize>;

/** A number at a place of the header. */
template <typename T>
T
ValueAt(const Header & header, std::size_t place, bool isForeign)
{
  std::array<char, sizeof(T)> bytes{};
  std::copy_n(header.begin() + static_cast<std::ptrdiff_t>(place), sizeof(T), bytes.begin());
  if (isForeign)
  {
    std::reverse(bytes.begin(), bytes.end());
  }
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

/** Of a name with this extension, gzipped or not, the one of its header. */
std::string
HeaderOf(const std::string & path)
{
  const std::size_t dot = path.rfind(".img");
  const bool        isOfPair = dot != std::string::npos && (path.size() == dot + 4 || path.substr(dot) == ".img.gz");
  return isOfPair ? path.substr(0, dot) + ".hdr" + path.substr(dot + 4) : path;
}
} // namespace

void
RequireSoundNifti(const std::string & path)
{
  Header                                           header{};
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> stream(gzopen(HeaderOf(path).c_str(), "rb"), gzclose);
  if (!stream || gzread(stream.get(), header.data(), headerSize) != headerSize)
  {
    return;
  }
  const bool isForeign = ValueAt<std::int32_t>(header, 0, false) != headerSize;
  if (ValueAt<std::int32_t>(header, 0, isForeign) != headerSize)
  {
    return;
  }
  constexpr std::size_t  magicPlace = 344;
  constexpr std::int16_t mostDimensions = 7;
  const auto             dimensions = ValueAt<std::int16_t>(header, 40, isForeign);
  if (dimensions < 1 || dimensions > mostDimensions)
  {
    throw std::runtime_error("the header has " + std::to_string(dimensions) + " dimensions, must be in 1 .. 7");
  }
  // The sizes of voxels, the offset and scale of the values; of NIfTI the places, too.
  std::vector<std::pair<std::size_t, std::size_t>> floats{ { 76, 108 } };
  if (header[magicPlace] == 'n')
  {
    floats = { { 76, 120 }, { 256, 328 } };
  }
  constexpr float most = 1e15f;
  for (const auto & [begin, end] : floats)
  {
    for (std::size_t place = begin; place < end; place += sizeof(float))
    {
      const auto value = ValueAt<float>(header, place, isForeign);
      if (!(std::abs(value) <= most))
      {
        throw std::runtime_error("the header has " + std::to_string(value) + " at byte " + std::to_string(place) +
                                 ", which is no size, place or scale");
      }
    }
  }
}
} // namespace tissue
