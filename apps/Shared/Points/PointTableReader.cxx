/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointTableReader.h"

namespace tissue
{
Point
PointTableReader::ReadPoint(const DelimitedText::Record & row) const
{
  return AtLine(row.line, [&] {
    Point point{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      point[axis] = m_Numbers.ReadNumber(row.fields, m_Columns.coordinates[axis]);
    }
    return point;
  });
}

} // namespace tissue
