/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/SummaryRows.h"

#include "Shared/Points/PointColumnName.h"
#include "Shared/Points/PointTableHeader.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace tissue
{
namespace
{
/** In small letters, without all but letters, digits and percent signs. */
std::string
Simplify(const std::string & text)
{
  std::string result;
  for (const char c : ToLower(text))
  {
    const bool isKept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '%';
    result += isKept ? std::string(1, c) : std::string();
  }
  return result;
}

/** The words that hardly name anything but a summary. */
bool
IsMeanOrDeviation(const std::string & text)
{
  static const std::set<std::string> words{
    "mean",   "average",           "avg",    "sd",     "std",        "stdev",
    "stddev", "standarddeviation", "meansd", "median", "mittelwert", "moyenne"
  };
  return text.size() < 30 && words.count(Simplify(text)) > 0;
}

bool
IsOtherSummary(const std::string & text)
{
  static const std::set<std::string> words{ "min", "minimum", "max", "maximum",  "sum", "total", "count", "number",
                                            "sem", "stderr",  "var", "variance", "cv",  "25%",   "50%",   "75%" };
  return text.size() < 30 && words.count(Simplify(text)) > 0;
}

/** The first field that is a word of summary; null if there is none. */
const std::string *
FindWord(const DelimitedText::Record & row)
{
  const auto at = std::find_if(row.fields.begin(), row.fields.end(), [](const std::string & field) {
    return IsMeanOrDeviation(field) || IsOtherSummary(field);
  });
  return at == row.fields.end() ? nullptr : &*at;
}

bool
HasMeanOrDeviation(const DelimitedText::Record & row)
{
  return std::any_of(row.fields.begin(), row.fields.end(), IsMeanOrDeviation);
}

/** As many as the coordinates of a point at least. */
bool
HasThreeNumbers(const DelimitedText::Record & row)
{
  return std::count_if(row.fields.begin(), row.fields.end(), LooksLikeNumber) >= 3;
}

[[noreturn]] void
Refuse(const DelimitedText::Record & row)
{
  throw std::runtime_error("line " + std::to_string(row.line) + ": " + QuoteName(*FindWord(row)) +
                           " may be a row of summary, which is no point: delete it, or give the point another name");
}
} // namespace

std::vector<std::string>
DropSummaryRows(std::vector<DelimitedText::Record> & rows)
{
  const auto hasWord = [](const DelimitedText::Record & row) { return FindWord(row) != nullptr; };
  const auto begin = std::find_if_not(rows.rbegin(), rows.rend(), hasWord).base();
  if (2 * std::count_if(rows.begin(), rows.end(), hasWord) > static_cast<std::ptrdiff_t>(rows.size()))
  {
    return {};
  }
  const auto inside = std::find_if(rows.begin(), begin, HasMeanOrDeviation);
  if (inside != begin)
  {
    Refuse(*inside);
  }
  if (begin == rows.end())
  {
    return {};
  }
  const auto point = std::find_if(begin, rows.end(), HasThreeNumbers);
  if (point != rows.end() && std::none_of(begin, rows.end(), HasMeanOrDeviation))
  {
    Refuse(*point);
  }
  std::string              names;
  std::vector<std::size_t> lines;
  for (auto row = begin; row != rows.end(); ++row)
  {
    names += (names.empty() ? "" : ", ") + QuoteName(*FindWord(*row));
    lines.push_back(row->line);
  }
  rows.erase(begin, rows.end());
  return { NameLines(lines) + " left out: a summary (" + names + ")" };
}
} // namespace tissue
