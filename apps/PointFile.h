/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointFile_h
#define PointFile_h

#include "TissueTessellationCore/Types.h"

#include <string>
#include <utility>
#include <vector>

namespace tissue
{
/** Points, in ITK's physical coordinates (LPS), and what is known of each. */
struct PointTable
{
  using Column = std::pair<std::string, std::vector<double>>;

  std::vector<Point> points;
  /** Numbers, one for each point, by name: "label", "scale", ... */
  std::vector<Column> columns;

  /** The column of this name, or nullptr. */
  const std::vector<double> *
  FindColumn(const std::string & name) const;
};

/** \brief Reads points from a file, whose format its extension names.
 *
 * - `.csv`: a header, then one row for each point. Columns of the coordinates are named x, y, z, or begin with x_, y_,
 * z_ (x_um), or end with _x, _y, _z (centroid_x) or CenterX, CenterY, CenterZ; upper or lower case; the first such
 *   triple in this order counts. Other columns of numbers alone are kept.
 * - `.fcsv`: fiducials of 3D Slicer, in RAS or LPS as the file says (RAS where it does not).
 * - `.vtp`: the points of a vtkPolyData, with its point arrays of one component.
 *
 * \throws std::runtime_error with file and line for what is no such file, columns that miss, text in the place of
 * numbers, and coordinates that are not finite. */
PointTable
ReadPoints(const std::string & path);

/** \brief Writes points; formats as above, fiducials in LPS. \throws std::runtime_error where it cannot.
 *
 * `format` is the extension of the path that the file will have. */
void
WritePoints(const PointTable & table, const std::string & path, const std::string & format);

/** \throws std::runtime_error unless the path has an extension that WritePoints() knows; returns it. */
std::string
RequirePointFormat(const std::string & path);
} // namespace tissue

#endif
