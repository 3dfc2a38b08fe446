/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointTableHeader.h"

#include "Shared/Points/PointColumnName.h"
#include "Shared/Points/PointColumns.h"
#include "Shared/Points/PointTableReader.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace tissue
{
namespace
{
using Fields = std::vector<std::string>;
using Records = std::vector<DelimitedText::Record>;

const std::string noField;

const std::string &
FieldOrEmpty(const Fields & fields, std::size_t column)
{
  return column < fields.size() ? fields[column] : noField;
}

bool
HasNumbers(const Fields & fields)
{
  return std::any_of(fields.begin(), fields.end(), LooksLikeNumber);
}

std::size_t
CountTexts(const Fields & fields)
{
  return static_cast<std::size_t>(
    std::count_if(fields.begin(), fields.end(), [](const std::string & field) { return !field.empty(); }));
}

/** Whether the line, below one of names, says more of the columns. */
bool
ContinuesNames(const Fields & fields, const Fields & names, const PointFileOptions & options)
{
  if (HasNumbers(fields))
  {
    return false;
  }
  bool hasUnits = false;
  for (std::size_t i = 0; i < std::min(fields.size(), names.size()); ++i)
  {
    hasUnits = hasUnits || (ParseAxisName(names[i]) && ParseUnit(fields[i]));
  }
  return hasUnits || HasPointColumns(fields, options);
}

/** Adds what another line of names says: names where there are none, and units. */
void
AddNames(const Fields & more, Fields & names)
{
  for (std::size_t i = 0; i < more.size() && i < names.size(); ++i)
  {
    const auto axis = ParseAxisName(names[i]);
    if (names[i].empty())
    {
      names[i] = more[i];
    }
    else if (axis && axis->unit.empty() && ParseUnit(more[i]))
    {
      const bool isBare = more[i].front() != '(' && more[i].front() != '[';
      names[i] += isBare ? " (" + more[i] + ")" : " " + more[i];
    }
  }
}

/** The names in the record of this index and in the lines around it that belong to them. */
PointTableHeader
JoinNames(const Records & records, std::size_t index, const PointFileOptions & options)
{
  PointTableHeader header;
  header.names = records[index].fields;
  header.line = records[index].line;
  std::size_t begin = index;
  for (; begin > 0; --begin)
  {
    const Fields & fields = records[begin - 1].fields;
    if (HasNumbers(fields) || CountTexts(fields) < 2 || fields.size() != header.names.size())
    {
      break;
    }
    AddNames(fields, header.names);
  }
  header.firstRow = index + 1;
  for (; header.firstRow < records.size() &&
         ContinuesNames(records[header.firstRow].fields, records[index].fields, options);
       ++header.firstRow)
  {
    AddNames(records[header.firstRow].fields, header.names);
  }
  std::vector<std::size_t> leftOut;
  for (std::size_t i = 0; i < begin; ++i)
  {
    if (CountTexts(records[i].fields) > 1)
    {
      leftOut.push_back(records[i].line);
    }
  }
  if (!leftOut.empty())
  {
    header.warnings.push_back(NameLines(leftOut) + " before the names of the columns (line " +
                              std::to_string(header.line) + ") left out");
  }
  return header;
}

/** The last comment before the rows that has names of coordinates. */
std::optional<PointTableHeader>
FindNamesInComments(const DelimitedText & text, const PointFileOptions & options)
{
  std::optional<PointTableHeader> header;
  for (const DelimitedText::Comment & comment : text.comments)
  {
    const Fields names = SplitFields(comment.text);
    if (comment.line < text.records.front().line && HasPointColumns(names, options))
    {
      header = PointTableHeader();
      header->names = names;
      header->line = comment.line;
    }
  }
  return header;
}

/** Without names of coordinates: the names by the last line before the rows, if there is any. */
PointTableHeader
NamesBefore(const Records & records, std::size_t firstRow)
{
  PointTableHeader header;
  header.firstRow = firstRow;
  header.line = records[std::min(firstRow, records.size() - 1)].line;
  const bool isTitle = firstRow > 0 && records.size() > firstRow && records[firstRow].fields.size() > 1 &&
                       records[firstRow - 1].fields.size() == 1;
  if (firstRow > 0 && !isTitle && !HasNumbers(records[firstRow - 1].fields))
  {
    header.names = records[firstRow - 1].fields;
    header.line = records[firstRow - 1].line;
  }
  return header;
}

/** The columns of x, y and z where names do not tell them. */
std::vector<std::size_t>
NumberedColumns(const PointFileOptions & options)
{
  std::vector<std::size_t> columns;
  for (const std::string & wanted : options.columns)
  {
    if (const auto number = ToColumnNumber(wanted))
    {
      columns.push_back(*number);
    }
  }
  return columns.size() == 3 ? columns : std::vector<std::size_t>{ 0, 1, 2 };
}

/** Whether the record has text in a column that has numbers in all that follow, of which there are some. */
bool
IsUnlikeRows(const Records & records, std::size_t index)
{
  const Fields & fields = records[index].fields;
  for (std::size_t column = 0; records.size() > index + 2 && column < fields.size(); ++column)
  {
    const bool isText = !fields[column].empty() && !LooksLikeNumber(fields[column]);
    if (isText && std::all_of(records.begin() + static_cast<std::ptrdiff_t>(index) + 1,
                              records.end(),
                              [&](const auto & r) { return LooksLikeNumber(FieldOrEmpty(r.fields, column)); }))
    {
      return true;
    }
  }
  return false;
}

/** Whether the coordinates are whole numbers and none of those that follow is. */
bool
IsWholeUnlikeRows(const Records & records, std::size_t index, const std::vector<std::size_t> & columns)
{
  const auto isWhole = [&](const DelimitedText::Record & record, std::size_t column) {
    return FieldOrEmpty(record.fields, column).find_first_of(".,eE") == std::string::npos;
  };
  const auto begin = records.begin() + static_cast<std::ptrdiff_t>(index);
  return records.end() - begin > 4 &&
         std::all_of(columns.begin(), columns.end(), [&](std::size_t c) { return isWhole(*begin, c); }) &&
         std::all_of(begin + 1, records.end(), [&](const auto & record) {
           return std::none_of(columns.begin(), columns.end(), [&](std::size_t c) { return isWhole(record, c); });
         });
}

/** The first row of a table without names of coordinates. */
PointTableHeader
FindFirstRow(const Records & records, const PointFileOptions & options)
{
  const std::vector<std::size_t> columns = NumberedColumns(options);
  const auto                     isRow = [&](const DelimitedText::Record & record) {
    return std::all_of(columns.begin(), columns.end(), [&](std::size_t column) {
      return LooksLikeNumber(FieldOrEmpty(record.fields, column));
    });
  };
  const auto first = std::find_if(records.begin(), records.end(), isRow);
  if (first == records.end())
  {
    // The names, if any, are in the last line before those that have numbers.
    const auto numbers =
      std::find_if(records.begin(), records.end(), [](const auto & record) { return HasNumbers(record.fields); });
    return NamesBefore(records, numbers == records.end() ? 1 : static_cast<std::size_t>(numbers - records.begin()));
  }
  PointTableHeader header = NamesBefore(records, static_cast<std::size_t>(first - records.begin()));
  if (!header.names.empty())
  {
    return header;
  }
  std::vector<std::size_t> leftOut;
  while (!options.columns.empty() && (IsUnlikeRows(records, header.firstRow) ||
                                      (!leftOut.empty() && IsWholeUnlikeRows(records, header.firstRow, columns))))
  {
    leftOut.push_back(records[header.firstRow++].line);
  }
  header.line = records[header.firstRow].line;
  // Where names were not given, pandas numbers the columns.
  const bool isCount = options.columns.empty() && records.size() > 1 && first->fields == Fields{ "0", "1", "2" };
  if (isCount || (!options.columns.empty() && IsWholeUnlikeRows(records, header.firstRow, columns)))
  {
    throw std::runtime_error(NameLines({ header.line }) +
                             (isCount ? " may count the columns" : " alone has whole numbers") +
                             ": is it a point (--firstLine " + std::to_string(header.line) + ") or none (--firstLine " +
                             std::to_string(records[header.firstRow + 1].line) + ")?");
  }
  if (!leftOut.empty())
  {
    header.warnings.push_back(NameLines(leftOut) +
                              " left out, being unlike all others: --firstLine says the line of the first point");
  }
  return header;
}

/** TrackMate's tables of edges and tracks have means of spots, under the same short names as the spots.
 * \throws std::runtime_error: one of these tables, of which no columns are chosen. */
void
RefuseEdgesAndTracks(const Records & records, const PointFileOptions & options)
{
  if (records.empty() || !options.columns.empty())
  {
    return;
  }
  for (const std::string & name : records.front().fields)
  {
    const bool isOfEdges = name == "EDGE_X_LOCATION" || name == "SPOT_SOURCE_ID";
    if (isOfEdges || name == "TRACK_X_LOCATION")
    {
      throw std::runtime_error("line " + std::to_string(records.front().line) + ": the column " + QuoteName(name) +
                               " is of TrackMate's table of " + (isOfEdges ? "edges" : "tracks") +
                               ", the points are in that of spots; --columns X Y Z takes others all the same");
    }
  }
}
} // namespace

PointTableHeader
FindPointTableHeader(const DelimitedText & text, const PointFileOptions & options)
{
  const Records & records = text.records;
  RefuseEdgesAndTracks(records, options);
  const auto isBefore = [&options](const DelimitedText::Record & record) {
    return options.firstLine == 0 || record.line < options.firstLine;
  };
  const auto end = std::find_if_not(records.begin(), records.end(), isBefore);
  if (end == records.end() && options.firstLine > 0)
  {
    throw std::runtime_error("there is nothing from line " + std::to_string(options.firstLine) + " on (--firstLine)");
  }
  // Names are among the first lines: to look for them takes longer than to read numbers.
  constexpr std::ptrdiff_t most = 1000;
  const auto               last = records.begin() + std::min(most, end - records.begin());
  const auto               names =
    std::find_if(records.begin(), last, [&](const auto & record) { return HasPointColumns(record.fields, options); });
  std::optional<PointTableHeader> header;
  if (names != last)
  {
    header = JoinNames(records, static_cast<std::size_t>(names - records.begin()), options);
  }
  else
  {
    header = FindNamesInComments(text, options);
  }
  const std::size_t firstRow = static_cast<std::size_t>(end - records.begin());
  if (options.firstLine > 0)
  {
    header = header ? *header : NamesBefore(records, firstRow);
    header->firstRow = firstRow;
  }
  return header ? *header : FindFirstRow(records, options);
}

bool
LooksLikeNumber(const std::string & text)
{
  const std::size_t comma = text.find(',');
  return ToNumber(comma == std::string::npos ? text : std::string(text).replace(comma, 1, ".")).has_value();
}

std::string
NameLines(const std::vector<std::size_t> & lines)
{
  constexpr std::size_t most = 5;
  std::string           text = lines.size() == 1 ? "line " : "lines ";
  for (std::size_t i = 0; i < std::min(lines.size(), most); ++i)
  {
    text += (i == 0 ? "" : i + 1 == lines.size() ? " and " : ", ") + std::to_string(lines[i]);
  }
  return text + (lines.size() > most ? ", ..." : "");
}
} // namespace tissue
