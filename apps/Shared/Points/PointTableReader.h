/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointTableReader_h
#define PointTableReader_h

#include "Shared/Points/DelimitedText.h"
#include "Shared/Points/PointColumns.h"
#include "TissueTessellationCore/Common/Types.h"

#include <stdexcept>

namespace tissue
{
/** What `work` returns; its errors get the line before them. */
template <typename TWork>
auto
AtLine(std::size_t line, const TWork & work)
{
  try
  {
    return work();
  }
  catch (const std::runtime_error & error)
  {
    throw std::runtime_error("line " + std::to_string(line) + ": " + error.what());
  }
}

/** Reads the lines of a table of points. Errors are std::runtime_error that name line, column and value. */
class PointTableReader
{
public:
  using Records = std::vector<DelimitedText::Record>;

  /** \param names of the columns, for messages; empty where they have none. */
  PointTableReader(const std::vector<std::string> & names, const PointColumns & columns)
    : m_Names(names)
    , m_Columns(columns)
  {}

  /** Finds whether the numbers have a decimal point or comma; a point before.
   * \throws std::runtime_error: both, separators of thousands, or commas that may be either: three digits behind all of
   * them, and numbers without. */
  void
  FindDecimalSign(const Records & rows);

  /** \throws std::runtime_error: text in place of a number, a number that is not finite, a missing column. */
  Point
  ReadPoint(const DelimitedText::Record & row) const;

  /** The labels of all rows; empty if they are names, in any row of text.
   * \throws std::runtime_error: no text, a number below 0 or one that is not whole. */
  std::vector<Label>
  ReadLabels(const Records & rows) const;

private:
  double
  ReadCoordinate(const std::vector<std::string> & fields, std::size_t column) const;

  Label
  ReadLabel(const std::vector<std::string> & fields, std::size_t column) const;

  [[noreturn]] void
  Refuse(const std::string & text, std::size_t column, const std::string & why) const;

  std::vector<std::string> m_Names;
  PointColumns             m_Columns;
  char                     m_DecimalSign = '.';
};

/** The field of a column.
 * \throws std::runtime_error where there are fewer. */
const std::string &
FieldAt(const std::vector<std::string> & fields, std::size_t column);
} // namespace tissue

#endif
