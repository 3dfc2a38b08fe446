/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointColumnName.h"

#include "Shared/Points/DelimitedText.h"

#include <algorithm>
#include <regex>
#include <utility>

namespace tissue
{
namespace
{
/** Longer texts are no names; std::regex takes the stack for each letter. */
constexpr std::size_t longestName = 100;

const std::string unitPattern =
  "(nm|um|mm|cm|m|(?:nano|micro|milli|centi)?met(?:er|re)s?|microns?|px|pix|pixels?|vx|vox|"
  "voxels?|units?|calibrated|physical)";

/** Behind a sign, or in brackets. */
const std::string unitSuffix = "(?:(?:[ _.,:/-]+(?:in )?|[ _.,-]*[(\\[] ?(?:in )?)" + unitPattern + " ?[)\\]]?)?";

const std::string objects =
  "(?:(?:spot|cell|nucle(?:us|i)|object|particle|blob|seed|region|soma|roi|segment)s?[ _.-]?)*";

const std::string centers =
  "(?:(?:bary[ _.-]?)?cent(?:er|re|roid|\\.)?|pos(?:ition)?|coord(?:inate)?s?|loc(?:ation)?|point)";

const std::string massCenters =
  "(?:cent(?:er|re)[ _.-]?of[ _.-]?(?:(?:homogeneous|image)[ _.-]?)?(?:mass|gravity)|com|cog|cm)";

/** In small letters; the sign of micro, one of two letters, as u, also where it was read in a wrong encoding before. */
std::string
Normalize(const std::string & name)
{
  std::string text = ToLower(TrimBlanks(name));
  for (const std::string micro : { "\xC3\x82\xC2\xB5", "\xC2\xB5", "\xCE\xBC" })
  {
    for (std::size_t at = text.find(micro); at != std::string::npos; at = text.find(micro, at))
    {
      text.replace(at, micro.size(), "u");
    }
  }
  return text;
}

std::string
ToUnit(const std::string & text)
{
  if (text.empty() || text == "nm" || text == "um" || text == "mm" || text == "cm" || text == "m")
  {
    return text;
  }
  if (text[0] == 'p' && text[1] != 'h')
  {
    return "voxels";
  }
  const std::pair<const char *, const char *> beginnings[] = {
    { "nano", "nm" }, { "micro", "um" }, { "milli", "mm" }, { "centi", "cm" }, { "met", "m" }, { "v", "voxels" }
  };
  for (const auto & [beginning, unit] : beginnings)
  {
    if (text.find(beginning) == 0)
    {
      return unit;
    }
  }
  return "units";
}

/** Patterns with the axis as their first group and the unit as their second. */
std::optional<AxisName>
Match(const std::string & name, const std::regex & pattern, int rank)
{
  std::smatch match;
  if (!std::regex_match(name, match, pattern))
  {
    return std::nullopt;
  }
  AxisName   result;
  const char axis = *match[1].first;
  result.axis = static_cast<std::size_t>(axis < 'x' ? axis - '0' : axis - 'x');
  result.stem = name;
  result.stem[static_cast<std::size_t>(match.position(1))] = '#';
  result.unit = ToUnit(match[2].str());
  result.rank = rank;
  return result;
}
} // namespace

std::optional<AxisName>
ParseAxisName(const std::string & name)
{
  static const std::regex plain("(?:" + objects + "(?:" + centers + "[ _.,-]*)?|c)([xyz])" + unitSuffix);
  static const std::regex reversed("([xyz])(?:[ _.,-]*" + centers + "|c)" + unitSuffix);
  static const std::regex mass(objects + massCenters + "[ _.-]?([xyz])" + unitSuffix);
  static const std::regex massReversed("([xyz])(?:[ _.,-]*" + massCenters + "|m)" + unitSuffix);
  static const std::regex cellProfiler("(?:[a-z0-9]+_)?(?:location|areashape)_center_([xyz])()");
  static const std::regex ilastik("(?:center of the object|region ?center|object[ _]?center)[ _]([0-2])()");
  const std::string       text = name.size() <= longestName ? Normalize(name) : std::string();
  for (const auto & [pattern, rank] :
       { std::pair(&plain, 0), std::pair(&reversed, 0), std::pair(&mass, 1), std::pair(&massReversed, 1) })
  {
    if (auto axis = Match(text, *pattern, rank))
    {
      return axis;
    }
  }
  if (auto axis = Match(text, cellProfiler, text.find("areashape") != std::string::npos ? 1 : 0))
  {
    axis->isMostlyInVoxels = true;
    return axis;
  }
  auto axis = Match(text, ilastik, 0);
  if (axis)
  {
    axis->unit = "voxels";
  }
  return axis;
}

std::optional<int>
ParseNumberedAxis(const std::string & name)
{
  static const std::regex pattern("(?:(?:weighted[ _-])?centroid(?:[ "
                                  "_-]weighted)?|axis|dim(?:ension)?|coord(?:inate)?s?|pos(?:ition)?)[ _-]?([0-4])");
  std::smatch             match;
  const std::string       text = name.size() <= longestName ? Normalize(name) : std::string();
  return std::regex_match(text, match, pattern) ? std::make_optional(*match[1].first - '0') : std::nullopt;
}

std::optional<std::string>
ParseUnit(const std::string & text)
{
  static const std::regex pattern("[(\\[]?" + unitPattern + "[)\\]]?");
  std::smatch             match;
  const std::string       name = text.size() <= longestName ? Normalize(text) : std::string();
  return std::regex_match(name, match, pattern) ? std::make_optional(ToUnit(match[1].str())) : std::nullopt;
}

std::optional<int>
RankLabelName(const std::string & name)
{
  static const std::regex others(
    "(?:cell|object|nucleus|spot)[ _]?label|label[ _]?(?:id|number)|labelimage_oid|object[ _]?number");
  const std::string text = name.size() <= longestName ? Normalize(name) : std::string();
  return text == "label"                  ? std::make_optional(0)
         : std::regex_match(text, others) ? std::make_optional(1)
                                          : std::nullopt;
}

std::optional<int>
RankCellName(const std::string & name)
{
  static const std::regex ofCells(
    "(?:cell|object|obj|nucleus|spot|region|segment|roi)s?[ _.-]?(?:id|index|idx|number|num|nr|no)?\\.?");
  static const std::regex ids("id|ids|index|#");
  static const std::regex names("names?");
  const auto              rank = RankLabelName(name);
  const std::string       text = name.size() <= longestName ? Normalize(name) : std::string();
  return rank                              ? rank
         : text == "labels"                ? std::make_optional(1)
         : std::regex_match(text, ofCells) ? std::make_optional(2)
         : std::regex_match(text, ids)     ? std::make_optional(3)
         : std::regex_match(text, names)   ? std::make_optional(4)
                                           : std::nullopt;
}

std::optional<int>
RankFrameName(const std::string & name)
{
  const std::string       of = "(?:(?:spot|cell|pos(?:ition)?|metadata|slice)[ _])?";
  const std::string       unit = "(?: ?[(\\[][a-z. ]*[)\\]]|_(?:s|sec|seconds?|min|minutes?|h|hours?))?";
  static const std::regex frames(of +
                                 "(?:frames?|tp|time[ _-]?(?:points?|steps?|frames?|ind(?:ex|ices))|t[ _]index)"
                                 "(?:[ _](?:id|idx|index|number|no\\.?|nr\\.?))?" +
                                 unit);
  static const std::regex times(of + "(?:t|time|[hd]pf)" + unit);
  static const std::regex images("image[ _]?number");
  const std::string       text = name.size() <= longestName ? Normalize(name) : std::string();
  int                     rank = 0;
  for (const std::regex * pattern : { &frames, &times, &images })
  {
    if (std::regex_match(text, *pattern))
    {
      return rank;
    }
    ++rank;
  }
  return std::nullopt;
}

std::string
QuoteName(const std::string & name)
{
  constexpr std::size_t most = 60;
  std::size_t           size = std::min(most, name.size());
  // Not within a letter of UTF-8.
  while (size < name.size() && (static_cast<unsigned char>(name[size]) >> 6) == 2)
  {
    --size;
  }
  return "'" + name.substr(0, size) + (size < name.size() ? "...'" : "'");
}

std::string
ToLower(std::string text)
{
  // No part of a letter of UTF-8.
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  });
  return text;
}
} // namespace tissue
