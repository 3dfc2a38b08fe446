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
#include "Shared/Points/TableNumbers.h"
#include "TissueTessellationCore/Common/Types.h"

namespace tissue
{
/** Reads the lines of a table of points. Errors are std::runtime_error that name line, column and value. */
class PointTableReader
{
public:
  using Records = std::vector<DelimitedText::Record>;

  /** \param names of the columns, for messages; empty where they have none. */
  PointTableReader(const std::vector<std::string> & names, const PointColumns & columns)
    : m_Numbers(names)
    , m_Columns(columns)
  {}

  /** As TableNumbers, of the coordinates. */
  void
  FindDecimalSign(const Records & rows)
  {
    m_Numbers.FindDecimalSign(rows, { m_Columns.coordinates.begin(), m_Columns.coordinates.end() });
  }

  /** \throws std::runtime_error: text in place of a number, a number that is not finite, a missing column. */
  Point
  ReadPoint(const DelimitedText::Record & row) const;

  /** As TableNumbers, of the labels. */
  std::vector<Label>
  ReadLabels(const Records & rows) const
  {
    return m_Numbers.ReadLabels(rows, *m_Columns.label);
  }

private:
  TableNumbers m_Numbers;
  PointColumns m_Columns;
};
} // namespace tissue

#endif
