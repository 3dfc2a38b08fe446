/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TableNumbers_h
#define TableNumbers_h

#include "Shared/Points/DelimitedText.h"
#include "TissueTessellationCore/Common/Types.h"

#include <stdexcept>
#include <string>
#include <vector>

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

/** Reads the numbers and labels of a table. Errors are std::runtime_error that name column and value, and the line
 * where several rows are read. */
class TableNumbers
{
public:
  using Fields = std::vector<std::string>;
  using Records = std::vector<DelimitedText::Record>;

  /** \param names of the columns, for messages; empty where they have none. */
  explicit TableNumbers(const std::vector<std::string> & names)
    : m_Names(names)
  {}

  /** Finds whether the numbers of some columns have a decimal point or comma; a point before.
   * \throws std::runtime_error: both, separators of thousands, or commas that may be either: three digits behind all of
   * them, and numbers without. */
  void
  FindDecimalSign(const Records & rows, const std::vector<std::size_t> & columns);

  /** \throws std::runtime_error: text in place of a number, a number that is not finite, a missing column. */
  double
  ReadNumber(const Fields & fields, std::size_t column) const;

  /** The labels of all rows; empty if they are names, in any row of text.
   * \throws std::runtime_error: no text, a number below 0 or one that is not whole. */
  std::vector<Label>
  ReadLabels(const Records & rows, std::size_t column) const;

  [[noreturn]] void
  Refuse(const std::string & text, std::size_t column, const std::string & why) const;

private:
  Label
  ReadLabel(const Fields & fields, std::size_t column) const;

  std::vector<std::string> m_Names;
  char                     m_DecimalSign = '.';
};

/** The field of a column.
 * \throws std::runtime_error where there are fewer. */
const std::string &
FieldAt(const std::vector<std::string> & fields, std::size_t column);
} // namespace tissue

#endif
