/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointFileOptions_h
#define PointFileOptions_h

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tissue
{
/** What the user says of a file of points that it does not say itself. */
struct PointFileOptions
{
  /** The columns of x, y and z in a table, by their names or by their numbers, from 1 on; empty: found by names. */
  std::vector<std::string> columns;
  /** The one time point that is taken of a table with several, as it is written there, or "all"; empty: there is one.
   */
  std::string frame;
  /** The line of a table with the first point, from 1 on; 0: it is found. */
  std::size_t firstLine = 0;
  /** What the coordinates are multiplied by: the size of a voxel, for points in voxels. */
  std::optional<std::array<double, 3>> spacing;

  bool
  IsOfTables() const
  {
    return !columns.empty() || !frame.empty() || firstLine > 0;
  }
};
} // namespace tissue

#endif
