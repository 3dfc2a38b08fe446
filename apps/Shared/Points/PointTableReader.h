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
#include "Shared/Points/PointFileReader.h"

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

/** Reads points from the lines of a table. */
class PointTableReader
{
public:
  /** \param names of the columns, for messages; empty where they have none. */
  PointTableReader(const std::vector<std::string> & names, const PointColumns & columns)
    : m_Names(names)
    , m_Columns(columns)
  {}

  /** \throws std::runtime_error that names line, column and value: text in place of a number, a number that is not
   * finite, a label that is none, a missing column. */
  void
  AddPoint(const DelimitedText::Record & record, PointFile & file) const;

private:
  double
  ReadCoordinate(const std::vector<std::string> & fields, std::size_t column) const;

  Label
  ReadLabel(const std::vector<std::string> & fields, std::size_t column) const;

  [[noreturn]] void
  Refuse(const std::string & text, std::size_t column, const std::string & why) const;

  std::vector<std::string> m_Names;
  PointColumns             m_Columns;
};
} // namespace tissue

#endif
