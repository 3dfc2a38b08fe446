/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointColumns.h"

#include <algorithm>
#include <regex>
#include <stdexcept>

namespace tissue
{
namespace
{
/** A column of coordinates. */
struct Coordinate
{
  std::size_t column;
  std::string unit;
};

std::string
Quote(const std::string & name)
{
  return "'" + name + "'";
}

std::string
ToLower(std::string text)
{
  // Whatever the locale, and no part of a letter of UTF-8.
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  });
  return text;
}

/** The axis and the unit, if the name is that of a coordinate. Suffixes that are no units of length are something
 * else: an error, an index, a size in pixels. */
std::optional<std::pair<char, std::string>>
ToAxis(const std::string & name)
{
  // In UTF-8 the sign of micro is one of two letters.
  static const std::regex pattern(
    "(?:(?:cent(?:er|re|roid)|pos(?:ition)?)[ _.-]?)?([xyz])"
    "(?:(?:[ _.-]|[ _.-]?[(\\[])(nm|(?:u|µ|μ)m|mm|cm|m|(?:nano|micro|milli)?met(?:er|re)s?|microns?)[)\\]]?)?");
  std::smatch       match;
  const std::string text = ToLower(name);
  return std::regex_match(text, match, pattern) ? std::make_optional(std::make_pair(*match[1].first, match[2].str()))
                                                : std::nullopt;
}

[[noreturn]] void
RefuseMissing(char axis, const std::vector<std::string> & names)
{
  static const std::regex numbered("(weighted_)?centroid(_weighted)?[ _-]?[0-2]");
  const auto              isNumbered = [](const auto & name) { return std::regex_match(ToLower(name), numbered); };
  const auto              ofNumber = std::find_if(names.begin(), names.end(), isNumbered);
  if (ofNumber != names.end())
  {
    throw std::runtime_error("the column " + Quote(*ofNumber) +
                             " is numbered by the axes of an array, of which the first is mostly z: name its columns "
                             "x, y and z, in physical units");
  }
  constexpr std::size_t most = 10;
  std::string           list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
  {
    list += (i > 0 ? ", " : "") + Quote(names[i]);
  }
  const std::string letter(1, axis);
  throw std::runtime_error("there is no column " + letter + " among " + list + (names.size() > most ? ", ..." : "") +
                           "; accepted are " + letter + ", center_" + letter + ", centroid_" + letter + ", position_" +
                           letter + ", each also with a unit of length, as " + letter + "_um or " + letter +
                           " (microns)");
}
} // namespace

PointColumns
FindPointColumns(const std::vector<std::string> & names)
{
  std::array<std::vector<Coordinate>, 3> found;
  std::vector<std::size_t>               labels;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (const auto axis = ToAxis(names[i]))
    {
      found[static_cast<std::size_t>(axis->first - 'x')].push_back({ i, axis->second });
    }
    else if (ToLower(names[i]) == "label")
    {
      labels.push_back(i);
    }
  }
  PointColumns columns;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const char letter = "xyz"[axis];
    if (found[axis].empty())
    {
      RefuseMissing(letter, names);
    }
    const Coordinate & first = found[axis].front();
    if (found[axis].size() > 1)
    {
      throw std::runtime_error("the columns " + Quote(names[first.column]) + " and " +
                               Quote(names[found[axis][1].column]) + " both are " + letter);
    }
    if (first.unit != found[0].front().unit)
    {
      throw std::runtime_error("the columns " + Quote(names[found[0].front().column]) + " and " +
                               Quote(names[first.column]) + " are of different units");
    }
    columns.coordinates[axis] = first.column;
  }
  if (labels.size() > 1)
  {
    throw std::runtime_error("the columns " + std::to_string(labels[0] + 1) + " and " + std::to_string(labels[1] + 1) +
                             " both are the label");
  }
  if (!labels.empty())
  {
    columns.label = labels.front();
  }
  return columns;
}
} // namespace tissue
