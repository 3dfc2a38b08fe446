/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/TableNumbers.h"

#include "Shared/Points/PointColumnName.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tissue
{
namespace
{
/** Whether the digits behind the only comma may be thousands: three. */
bool
MayBeThousands(const std::string & text)
{
  const std::size_t comma = text.find(',');
  return text.size() == comma + 4 && text.find_first_not_of("0123456789", comma + 1) == std::string::npos;
}
} // namespace

void
TableNumbers::FindDecimalSign(const Records & rows, const std::vector<std::size_t> & columns)
{
  bool                          hasPoints = false;
  bool                          hasWhole = false;
  bool                          mayAllBeThousands = true;
  const DelimitedText::Record * comma = nullptr;
  std::size_t                   commaColumn = 0;
  for (const DelimitedText::Record & row : rows)
  {
    for (const std::size_t column : columns)
    {
      const std::string & text = column < row.fields.size() ? row.fields[column] : std::string();
      const auto          commas = std::count(text.begin(), text.end(), ',');
      const bool          hasPoint = text.find('.') != std::string::npos;
      if (commas > 1 || (commas == 1 && hasPoint))
      {
        AtLine(row.line, [&] { this->Refuse(text, column, "has separators of thousands, which are not read"); });
      }
      hasPoints = hasPoints || hasPoint;
      hasWhole = hasWhole || (commas == 0 && !hasPoint && ToNumber(text));
      if (commas == 1)
      {
        mayAllBeThousands = mayAllBeThousands && MayBeThousands(text);
        commaColumn = comma == nullptr ? column : commaColumn;
        comma = comma == nullptr ? &row : comma;
      }
    }
  }
  if (comma != nullptr && (hasPoints || (hasWhole && mayAllBeThousands)))
  {
    AtLine(comma->line, [&] {
      this->Refuse(comma->fields[commaColumn],
                   commaColumn,
                   hasPoints ? "has a decimal comma where others have a decimal point"
                             : "may have a decimal comma or one of thousands, as others have none");
    });
  }
  m_DecimalSign = comma != nullptr ? ',' : '.';
}

std::vector<Label>
TableNumbers::ReadLabels(const Records & rows, std::size_t column) const
{
  const auto isName = [column](const DelimitedText::Record & row) {
    const std::string text = column < row.fields.size() ? row.fields[column] : std::string();
    return !text.empty() && !ToNumber(text);
  };
  std::vector<Label> labels;
  if (std::any_of(rows.begin(), rows.end(), isName))
  {
    return labels;
  }
  for (const DelimitedText::Record & row : rows)
  {
    labels.push_back(AtLine(row.line, [&] { return this->ReadLabel(row.fields, column); }));
  }
  return labels;
}

double
TableNumbers::ReadNumber(const Fields & fields, std::size_t column) const
{
  std::string text = FieldAt(fields, column);
  if (m_DecimalSign != '.')
  {
    std::replace(text.begin(), text.end(), m_DecimalSign, '.');
  }
  const std::optional<double> value = ToNumber(text);
  if (!value)
  {
    const bool isName = column < m_Names.size() && !text.empty() && ToLower(text) == ToLower(m_Names[column]);
    this->Refuse(fields[column], column, isName ? "again: is there a second table in the file?" : "is no number");
  }
  if (!std::isfinite(*value))
  {
    this->Refuse(text, column, "must be finite");
  }
  return *value;
}

Label
TableNumbers::ReadLabel(const Fields & fields, std::size_t column) const
{
  const std::string & text = FieldAt(fields, column);
  Label               label = 0;
  const auto          result = std::from_chars(text.data(), text.data() + text.size(), label);
  if (result.ec == std::errc() && result.ptr == text.data() + text.size() && label >= 0)
  {
    return label;
  }
  // Of programs that write all numbers alike, "7.0", as far as doubles hold whole numbers.
  constexpr double            most = 9007199254740992.0;
  const std::optional<double> value = ToNumber(text);
  if (!value || !(*value >= 0.0 && *value < most) || *value != std::floor(*value))
  {
    this->Refuse(text, column, "is no whole number from 0 on");
  }
  return static_cast<Label>(*value);
}

void
TableNumbers::Refuse(const std::string & text, std::size_t column, const std::string & why) const
{
  throw std::runtime_error(QuoteName(text) + " in column " + std::to_string(column + 1) +
                           (column < m_Names.size() ? " (" + QuoteName(m_Names[column]) + ") " : " ") + why);
}

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
} // namespace tissue
