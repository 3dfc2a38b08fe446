/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/CellTable.h"

#include "Shared/Points/PointColumnName.h"
#include "Shared/Points/PointColumns.h"
#include "Shared/Points/SummaryRows.h"
#include "Shared/Points/TableNumbers.h"
#include "Shared/Points/TableRows.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

namespace tissue
{
namespace
{
using Fields = std::vector<std::string>;
using Records = std::vector<DelimitedText::Record>;

std::string
ListNames(const Fields & names)
{
  constexpr std::size_t most = 12;
  std::string           text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
  {
    text += (i > 0 ? ", " : "") + QuoteName(names[i]);
  }
  return text + (names.size() > most ? ", ..." : "");
}

/** The column of the labels; nothing if there is none by that name.
 * \throws std::runtime_error: a number beyond the columns, two columns. */
std::optional<std::size_t>
FindLabelColumn(const Fields & names, const std::string & wanted)
{
  std::map<int, std::vector<std::size_t>> columnsOfRank;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const bool isWanted = !wanted.empty() && ToLower(names[i]) == ToLower(TrimBlanks(wanted));
    const auto rank = wanted.empty() ? RankCellName(names[i]) : isWanted ? std::make_optional(0) : std::nullopt;
    if (rank)
    {
      columnsOfRank[*rank].push_back(i);
    }
  }
  const auto number = columnsOfRank.empty() ? ToColumnNumber(wanted) : std::nullopt;
  if (number && *number >= names.size())
  {
    throw std::runtime_error("there are " + std::to_string(names.size()) + " columns, none of number " + wanted);
  }
  if (columnsOfRank.empty())
  {
    return number;
  }
  const std::vector<std::size_t> & columns = columnsOfRank.begin()->second;
  if (columns.size() > 1)
  {
    throw std::runtime_error("the columns " + std::to_string(columns[0] + 1) + " and " +
                             std::to_string(columns[1] + 1) + " both are the label (" + QuoteName(names[columns[0]]) +
                             ")");
  }
  return columns.front();
}

/** The names of the columns: in the first line, or else the last comment before the rows, that has one of labels. */
PointTableHeader
FindHeader(const DelimitedText & text, const std::string & labelColumn)
{
  constexpr std::size_t most = 1000;
  PointTableHeader      header;
  for (std::size_t i = 0; i < std::min(text.records.size(), most) && header.names.empty(); ++i)
  {
    const DelimitedText::Record & record = text.records[i];
    if (AtLine(record.line, [&] { return FindLabelColumn(record.fields, labelColumn); }))
    {
      header = { record.fields, record.line, i + 1, {} };
    }
  }
  for (const DelimitedText::Comment & comment : text.comments)
  {
    const Fields names = SplitFields(comment.text);
    if (comment.line < text.records.front().line && header.firstRow == 0 && FindLabelColumn(names, labelColumn))
    {
      header = { names, comment.line, 0, {} };
    }
  }
  if (header.names.empty())
  {
    throw std::runtime_error(
      "there is no column of labels (" + (labelColumn.empty() ? "label, cell_id, id, ..." : QuoteName(labelColumn)) +
      "); line " + std::to_string(text.records.front().line) + " has " + ListNames(text.records.front().fields));
  }
  if (header.firstRow > 1)
  {
    header.warnings.push_back("what is before the names of the columns, in line " + std::to_string(header.line) +
                              ", is left out");
  }
  return header;
}

/** Whether a line below the names says more of the columns: units, or other names. */
bool
ContinuesNames(const Fields & fields, std::size_t labelColumn)
{
  const std::string label = labelColumn < fields.size() ? fields[labelColumn] : std::string();
  return std::none_of(fields.begin(), fields.end(), LooksLikeNumber) && (label.empty() || RankCellName(label));
}

bool
IsMissing(const std::string & text)
{
  static const std::set<std::string> words{ "", "na", "n/a", "#n/a", "nan", "-nan", "null", "none", "<na>", "-" };
  return words.count(ToLower(text)) > 0;
}

/** The labels of the rows, each once. */
void
ReadLabels(const Records & rows, std::size_t column, const TableNumbers & numbers, CellTable & table)
{
  table.labels = numbers.ReadLabels(rows, column);
  std::map<std::string, std::size_t> lineOf;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const std::string & text =
      AtLine(rows[i].line, [&]() -> const std::string & { return FieldAt(rows[i].fields, column); });
    const std::string name = table.labels.empty() ? text : std::to_string(table.labels[i]);
    const auto        known = lineOf.emplace(name, rows[i].line);
    if (!known.second)
    {
      throw std::runtime_error("line " + std::to_string(rows[i].line) + ": the label " + QuoteName(name) +
                               " is that of line " + std::to_string(known.first->second) +
                               ", too: a table has one row a cell");
    }
    table.names.push_back(text);
    table.lines.push_back(rows[i].line);
  }
}

CellTable::Column
ReadColumn(const Records & rows, std::size_t column, const std::string & name, const TableNumbers & numbers,
           bool isOfNumbers)
{
  CellTable::Column result{ name, {}, {} };
  for (const DelimitedText::Record & row : rows)
  {
    const std::string text = column < row.fields.size() ? row.fields[column] : std::string();
    const bool        isMissing = IsMissing(text);
    if (isOfNumbers)
    {
      result.numbers.push_back(isMissing ? std::numeric_limits<double>::quiet_NaN()
                                         : AtLine(row.line, [&] { return numbers.ReadNumber(row.fields, column); }));
    }
    else
    {
      result.texts.push_back(isMissing ? std::string() : text);
    }
  }
  return result;
}

/** The columns of values that have numbers, or nothing at all; of others, those of text. */
std::vector<std::size_t>
FindColumns(const Records & rows, const Fields & names, std::size_t labelColumn, bool ofNumbers)
{
  std::vector<std::size_t> columns;
  for (std::size_t column = 0; column < names.size(); ++column)
  {
    const auto has = [&](const auto & isSuch) {
      return std::any_of(rows.begin(), rows.end(), [&](const DelimitedText::Record & row) {
        return column < row.fields.size() && !IsMissing(row.fields[column]) && isSuch(row.fields[column]);
      });
    };
    const bool hasText = has([](const std::string & text) { return !LooksLikeNumber(text); });
    const bool isText = hasText && !has(LooksLikeNumber);
    if (column != labelColumn && !names[column].empty() && isText != ofNumbers)
    {
      columns.push_back(column);
    }
  }
  return columns;
}

void
RequireNames(const Fields & names, std::size_t line, CellTable & table)
{
  std::set<std::string> known;
  for (std::size_t column = 0; column < names.size(); ++column)
  {
    if (names[column].empty())
    {
      table.warnings.push_back("column " + std::to_string(column + 1) + " has no name and is left out");
    }
    else if (!known.insert(names[column]).second)
    {
      throw std::runtime_error("line " + std::to_string(line) + ": two columns have the name " +
                               QuoteName(names[column]));
    }
  }
}
} // namespace

CellTable
ReadCellTable(std::istream & stream, const std::string & labelColumn)
{
  const DelimitedText text = ReadDelimitedText(stream);
  if (text.records.empty())
  {
    throw std::runtime_error("the table is empty");
  }
  PointTableHeader  header = FindHeader(text, labelColumn);
  const std::size_t found = *FindLabelColumn(header.names, labelColumn);
  while (header.firstRow < text.records.size() && ContinuesNames(text.records[header.firstRow].fields, found))
  {
    ++header.firstRow;
  }
  Records      rows(text.records.begin() + static_cast<std::ptrdiff_t>(header.firstRow), text.records.end());
  const Fields ofSummary = DropSummaryRows(rows);
  if (rows.empty())
  {
    throw std::runtime_error("there are no rows below the names of the columns (line " + std::to_string(header.line) +
                             ")");
  }
  const std::size_t numberOfNames = header.names.size();
  MatchNames(rows, header);
  const std::size_t column = found + header.names.size() - numberOfNames;
  CellTable         table;
  table.warnings = header.warnings;
  table.warnings.insert(table.warnings.end(), ofSummary.begin(), ofSummary.end());
  RequireNames(header.names, header.line, table);
  TableNumbers numbers(header.names);
  const auto   ofNumbers = FindColumns(rows, header.names, column, true);
  const auto   ofText = FindColumns(rows, header.names, column, false);
  numbers.FindDecimalSign(rows, ofNumbers);
  ReadLabels(rows, column, numbers, table);
  for (std::size_t c = 0; c < header.names.size(); ++c)
  {
    const bool isOfNumbers = std::count(ofNumbers.begin(), ofNumbers.end(), c) > 0;
    if (isOfNumbers || std::count(ofText.begin(), ofText.end(), c) > 0)
    {
      table.columns.push_back(ReadColumn(rows, c, header.names[c], numbers, isOfNumbers));
    }
  }
  if (table.columns.empty())
  {
    throw std::runtime_error("line " + std::to_string(header.line) + ": there is no column of values beside that of " +
                             "the labels (" + QuoteName(header.names[column]) + ")");
  }
  return table;
}
} // namespace tissue
