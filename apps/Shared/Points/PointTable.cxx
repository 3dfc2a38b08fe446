/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointTable.h"

#include "Shared/Points/PointColumnName.h"
#include "Shared/Points/PointTableHeader.h"
#include "Shared/Points/PointTableReader.h"
#include "Shared/Points/SummaryRows.h"
#include "Shared/Points/TableRows.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace tissue
{
namespace
{
using Fields = std::vector<std::string>;
using Records = std::vector<DelimitedText::Record>;

bool
IsSameValue(const std::string & a, const std::string & b)
{
  const auto x = ToNumber(a);
  const auto y = ToNumber(b);
  return a == b || (x && y && *x == *y);
}

/** The different values of a column, in the order in which they come. */
Fields
ValuesOf(const Records & rows, std::size_t column)
{
  std::set<std::string> texts;
  std::set<double>      numbers;
  Fields                values;
  for (const DelimitedText::Record & row : rows)
  {
    const std::string & value = AtLine(row.line, [&]() -> const std::string & { return FieldAt(row.fields, column); });
    const auto          number = ToNumber(value);
    const bool          isFinite = number && std::isfinite(*number);
    if (isFinite ? numbers.insert(*number).second : texts.insert(value).second)
    {
      values.push_back(value);
    }
  }
  return values;
}

std::string
ListFrames(const Fields & values, const std::string & name)
{
  constexpr std::size_t most = 8;
  std::string           text = QuoteName(name) + " has " + std::to_string(values.size());
  text += values.size() == 1 ? " value" : " values";
  for (std::size_t i = 0; i < std::min(values.size(), most); ++i)
  {
    text += (i > 0 ? ", " : ": ") + values[i];
  }
  return text + (values.size() > most ? ", ..." : "");
}

/** Leaves the rows of one time point: the one that the options say, the only one, or all as they say. */
void
TakeFrame(Records & rows, const PointTableHeader & header, const PointColumns & columns, const std::string & frame)
{
  if (columns.frames.empty() && !frame.empty())
  {
    throw std::runtime_error("line " + std::to_string(header.line) +
                             ": there is no column of time points (t, time, frame, POSITION_T, ...), for --frame");
  }
  if (columns.frames.empty() || frame == "all")
  {
    return;
  }
  const auto        hasSeveral = [&rows](std::size_t column) { return ValuesOf(rows, column).size() > 1; };
  const auto        several = std::find_if(columns.frames.begin(), columns.frames.end(), hasSeveral);
  const auto        column = several != columns.frames.end() ? *several : columns.frames.front();
  const auto        isOther = [&](const auto & row) { return !IsSameValue(row.fields[column], frame); };
  const std::string values = ListFrames(ValuesOf(rows, column), header.names[column]);
  if (several != columns.frames.end() && frame.empty())
  {
    throw std::runtime_error(values + "; --frame takes the points of one of them, or of all");
  }
  if (!frame.empty())
  {
    rows.erase(std::remove_if(rows.begin(), rows.end(), isOther), rows.end());
  }
  if (rows.empty())
  {
    throw std::runtime_error("--frame " + frame + " is not there; " + values);
  }
}

/** The unit of the coordinates: of the names, or of the rows that say one. */
std::string
UnitOf(const Records & rows, const PointColumns & columns)
{
  if (!columns.unitColumn || !columns.unit.empty())
  {
    return columns.unit;
  }
  const Fields values = ValuesOf(rows, *columns.unitColumn);
  if (values.size() > 1)
  {
    throw std::runtime_error("the rows are of different units: " + QuoteName(values[0]) + ", " + QuoteName(values[1]));
  }
  return ParseUnit(values.front()).value_or("");
}

/** A warning of a point near the end that is the mean of all before it. */
Fields
FindMean(const std::vector<Point> & points, const Fields & places)
{
  constexpr std::size_t least = 8;
  constexpr std::size_t mostAtEnd = 6;
  constexpr double      tolerance = 1e-4;
  Point                 sum{};
  Point                 low = points.front();
  Point                 high = points.front();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    bool isMean = i >= least && i + mostAtEnd >= points.size();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double mean = sum[axis] / static_cast<double>(std::max<std::size_t>(i, 1));
      isMean = isMean && std::abs(points[i][axis] - mean) <= tolerance * (high[axis] - low[axis]);
      sum[axis] += points[i][axis];
      low[axis] = std::min(low[axis], points[i][axis]);
      high[axis] = std::max(high[axis], points[i][axis]);
    }
    if (isMean)
    {
      return { places[i] + " is the mean of all points before: is it a row of summary?" };
    }
  }
  return {};
}

void
SetLabels(const Records & rows, std::size_t column, const PointTableReader & reader, PointFile & file)
{
  file.labels = reader.ReadLabels(rows);
  if (!file.labels.empty())
  {
    return;
  }
  std::transform(rows.begin(), rows.end(), std::back_inserter(file.names), [column](const auto & row) {
    return FieldAt(row.fields, column);
  });
  file.warnings.push_back("the labels are names (" + QuoteName(file.names.front()) +
                          ", ...): the cells are numbered from 1 on; statistics and report have the names, too");
}

PointColumns
ColumnsOf(const PointTableHeader & header, const Records & rows, const PointFileOptions & options)
{
  return AtLine(header.line, [&] {
    if (header.names.empty() && options.columns.empty() && rows.front().fields.size() != 3)
    {
      throw std::runtime_error("there are " + std::to_string(rows.front().fields.size()) +
                               " columns and no line of their names before, which only three, x, y and z, can do "
                               "without: --columns X Y Z says their numbers, from 1 on");
    }
    return header.names.empty() && options.columns.empty() ? PointColumns() : FindPointColumns(header.names, options);
  });
}
/** The points of the rows, with their labels and what is to be said of them. */
PointFile
ReadRows(const Records & rows, const PointTableHeader & header, const PointColumns & columns)
{
  PointFile        file;
  PointTableReader reader(header.names, columns);
  reader.FindDecimalSign(rows);
  for (const DelimitedText::Record & row : rows)
  {
    file.points.push_back(reader.ReadPoint(row));
    file.places.push_back("line " + std::to_string(row.line));
  }
  file.unit = UnitOf(rows, columns);
  file.warnings = header.warnings;
  if (columns.label)
  {
    SetLabels(rows, *columns.label, reader, file);
  }
  const Fields ofMean = FindMean(file.points, file.places);
  file.warnings.insert(file.warnings.end(), ofMean.begin(), ofMean.end());
  return file;
}
} // namespace

PointFile
ReadPointTable(std::istream & stream, const PointFileOptions & options)
{
  const DelimitedText text = ReadDelimitedText(stream);
  if (text.records.empty())
  {
    return {};
  }
  PointTableHeader header = FindPointTableHeader(text, options);
  Records          rows(text.records.begin() + static_cast<std::ptrdiff_t>(header.firstRow), text.records.end());
  const Fields     ofSummary = DropSummaryRows(rows);
  header.warnings.insert(header.warnings.end(), ofSummary.begin(), ofSummary.end());
  if (rows.empty())
  {
    AtLine(header.line, [&] { FindPointColumns(header.names, options); });
    return {};
  }
  const std::size_t numberOfNames = header.names.size();
  MatchNames(rows, header);
  PointColumns columns = ColumnsOf(header, rows, options);
  if (!columns.label && header.names.size() > numberOfNames)
  {
    columns.label = 0;
  }
  TakeFrame(rows, header, columns, options.frame);
  if (columns.isMostlyInVoxels && !options.spacing)
  {
    header.warnings.push_back("the column " + QuoteName(header.names[columns.coordinates[0]]) +
                              " says no unit, and is mostly in voxels: --pointSpacing X Y Z gives their size");
  }
  return ReadRows(rows, header, columns);
}
} // namespace tissue
