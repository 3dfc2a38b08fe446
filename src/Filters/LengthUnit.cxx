/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LengthUnit.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

namespace tissue
{
std::optional<double>
ToMicrometers(const std::string & unit)
{
  static const std::map<std::string, double> micrometers{
    { "a", 1e-4 },         { "angstrom", 1e-4 },  { "nm", 1e-3 },   { "nanometer", 1e-3 }, { "um", 1.0 },
    { "micron", 1.0 },     { "micrometer", 1.0 }, { "mm", 1e3 },    { "millimeter", 1e3 }, { "cm", 1e4 },
    { "centimeter", 1e4 }, { "m", 1e6 },          { "meter", 1e6 }, { "inch", 25400.0 },   { "in", 25400.0 },
  };
  // The longer spelling before the one that it holds.
  static const std::pair<std::string, std::string> spellings[]{
    { "\\u00b5", "u" },  { "\\u03bc", "u" }, { "\xC2\xB5", "u" },  { "\xCE\xBC", "u" },  { "\xB5", "u" },
    { "\xC3\x85", "a" }, { "\xC5", "a" },    { "metre", "meter" }, { "inches", "inch" },
  };
  std::string name;
  for (const unsigned char c : unit)
  {
    if (c != 0 && !std::isspace(c))
    {
      name += static_cast<char>(c < 0x80 ? std::tolower(c) : c);
    }
  }
  for (const auto & [from, to] : spellings)
  {
    const std::size_t at = name.find(from);
    if (at != std::string::npos)
    {
      name.replace(at, from.size(), to);
    }
  }
  if (name.size() > 2 && name.back() == 's')
  {
    name.pop_back();
  }
  const auto found = micrometers.find(name);
  return found != micrometers.end() ? std::optional<double>(found->second) : std::nullopt;
}
} // namespace tissue
