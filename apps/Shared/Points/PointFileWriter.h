/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointFileWriter_h
#define PointFileWriter_h

#include "TissueTessellationCore/Common/Types.h"

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
  /** Numbers, one for each point, by name: "Label", "scale", ... */
  std::vector<Column> columns;

  /** The column of this name, or nullptr. */
  const std::vector<double> *
  FindColumn(const std::string & name) const;
};

/** \brief Writes points for ReadPointFile() and others: comma-separated values (`.csv`), fiducials of 3D Slicer in LPS
 * (`.fcsv`, which have room for labels alone), its markups (`.mrk.json` or another `.json`, by WriteMarkupsJson()),
 * points of a vtkPolyData (`.vtp`). \throws std::runtime_error where it cannot.
 *
 * `format` is the extension of the path that the file will have. */
void
WritePoints(const PointTable & table, const std::string & path, const std::string & format);

/** \throws std::runtime_error unless the path has an extension that WritePoints() knows; returns it. */
std::string
RequirePointFormat(const std::string & path);
} // namespace tissue

#endif
