/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointTableReader.h"

#include <charconv>
#include <cmath>

namespace tissue
{
namespace
{
const std::string &
FieldAt(const std::vector<std::string> & fields, std::size_t column)
{
  if (column >= fields.size())
  {
    throw std::runtime_error("there are " + std::to_string(fields.size()) + " columns, at least " +
                             std::to_string(column + 1) + " are needed");
  }
  return fields[column];
}
} // namespace

void
PointTableReader::AddPoint(const DelimitedText::Record & record, PointFile & file) const
{
  AtLine(record.line, [&] {
    Point point{};
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = this->ReadCoordinate(record.fields, m_Columns.coordinates[axis]);
    }
    file.points.push_back(point);
    file.places.push_back("line " + std::to_string(record.line));
    if (m_Columns.label)
    {
      file.labels.push_back(this->ReadLabel(record.fields, *m_Columns.label));
    }
  });
}

double
PointTableReader::ReadCoordinate(const std::vector<std::string> & fields, std::size_t column) const
{
  const std::string &         text = FieldAt(fields, column);
  const std::optional<double> value = ToNumber(text);
  if (!value)
  {
    this->Refuse(text, column, "is no number");
  }
  if (!std::isfinite(*value))
  {
    this->Refuse(text, column, "must be finite");
  }
  return *value;
}

Label
PointTableReader::ReadLabel(const std::vector<std::string> & fields, std::size_t column) const
{
  const std::string & text = FieldAt(fields, column);
  Label               label = 0;
  const auto          result = std::from_chars(text.data(), text.data() + text.size(), label);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() || label <= 0)
  {
    this->Refuse(text, column, "is no whole number above 0");
  }
  return label;
}

void
PointTableReader::Refuse(const std::string & text, std::size_t column, const std::string & why) const
{
  throw std::runtime_error("'" + text + "' in column " + std::to_string(column + 1) +
                           (column < m_Names.size() ? " ('" + m_Names[column] + "') " : " ") + why);
}
} // namespace tissue
