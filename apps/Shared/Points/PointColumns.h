/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointColumns_h
#define PointColumns_h

#include "Shared/Points/PointFileOptions.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tissue
{
/** Which columns of a table of points hold what. */
struct PointColumns
{
  std::array<std::size_t, 3> coordinates = { { 0, 1, 2 } };
  std::optional<std::size_t> label;
  /** Of time points, the one to choose by first. */
  std::vector<std::size_t> frames;
  /** Of the coordinates, as in AxisName. */
  std::string unit;
  /** The one that says the unit of each row, as of Imaris. */
  std::optional<std::size_t> unitColumn;
  /** As in AxisName, or the table is one of Vaa3D. */
  bool isMostlyInVoxels = false;
};

/** \brief Finds the columns of the coordinates, and those of labels and time points if there are such, by their names.
 *
 * Columns of coordinates are such by ParseAxisName(), or those that the options name or number. Of several sets of x, y
 * and z those with a unit are taken before those without, and these before those in voxels; the other way round where
 * the options say how large a voxel is.
 * \throws std::runtime_error: an axis without a column or with two, axes of different units, columns in voxels whose
 * size is not known, and such that are numbered, as by scikit-image, where 0 is the first axis of an array: mostly z;
 * of the options: no such column, or a name that two columns have. */
PointColumns
FindPointColumns(const std::vector<std::string> & names, const PointFileOptions & options = PointFileOptions());

/** Whether each of x, y and z has a column, by ParseAxisName(), or, where the options have names, these are there. */
bool
HasPointColumns(const std::vector<std::string> & names, const PointFileOptions & options);

/** The index of a column by its number, from 1 on; nothing if the text is no such number. */
std::optional<std::size_t>
ToColumnNumber(const std::string & text);
} // namespace tissue

#endif
