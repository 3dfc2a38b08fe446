/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/TableRows.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace tissue
{
namespace
{
using Fields = std::vector<std::string>;
using Records = std::vector<DelimitedText::Record>;

/** Without the empty fields at the end. */
std::size_t
CountToLast(const Fields & fields)
{
  const auto last = std::find_if(fields.rbegin(), fields.rend(), [](const auto & field) { return !field.empty(); });
  return static_cast<std::size_t>(fields.rend() - last);
}

/** Whether the first field of each row may be its name: text, or a whole number of its own. */
bool
HaveRowNames(const Records & rows)
{
  std::set<std::string> numbers;
  return std::all_of(rows.begin(), rows.end(), [&numbers](const DelimitedText::Record & row) {
    const std::string & first = row.fields.front();
    const bool          isWhole = !first.empty() && first.find_first_not_of("0123456789") == std::string::npos;
    return isWhole ? numbers.insert(first).second : !first.empty() && !LooksLikeNumber(first);
  });
}

[[noreturn]] void
RefuseCount(const DelimitedText::Record & row, std::size_t expected, const PointTableHeader & header)
{
  const std::string of =
    header.names.empty() ? " in line " + std::to_string(header.line) : " names, in line " + std::to_string(header.line);
  throw std::runtime_error(
    "line " + std::to_string(row.line) + ": there are " + std::to_string(row.fields.size()) + " values, but " +
    std::to_string(expected) + of +
    (row.fields.size() > expected && expected > 2 ? " (decimal commas must be quoted between commas)" : ""));
}

} // namespace

void
MatchNames(const Records & rows, PointTableHeader & header)
{
  const Fields &    names = header.names.empty() ? rows.front().fields : header.names;
  const std::size_t least = CountToLast(names);
  const std::size_t most = names.size();
  const bool        haveOneMore =
    std::all_of(rows.begin(), rows.end(), [most](const auto & row) { return row.fields.size() == most + 1; });
  const bool isLastEmpty =
    std::all_of(rows.begin(), rows.end(), [](const auto & row) { return row.fields.back().empty(); });
  if (haveOneMore && !isLastEmpty && HaveRowNames(rows))
  {
    header.names.insert(header.names.begin(), std::string());
    header.warnings.push_back("each row has a value more than there are names (line " + std::to_string(header.line) +
                              "): the first one is taken for the name of the row");
    return;
  }
  for (const DelimitedText::Record & row : rows)
  {
    if (row.fields.size() < least || CountToLast(row.fields) > most)
    {
      RefuseCount(row, row.fields.size() < least ? least : most, header);
    }
  }
}
} // namespace tissue
