/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointFileReader_h
#define PointFileReader_h

#include "TissueTessellationCore/Common/Types.h"

#include <string>
#include <vector>

namespace tissue
{
/** Points of a file in physical coordinates (LPS). */
struct PointFile
{
  std::vector<Point> points;
  /** Of each point; empty where the file has none. */
  std::vector<Label> labels;
  /** Of each point where it is in the file, for messages: "line 7". */
  std::vector<std::string> places;
};

/** Whether the name ends in one of the extensions of a point file: .csv, .fcsv, .json, .vtp. */
bool
IsPointFile(const std::string & path);

/** \brief Reads the points of a file.
 *
 * - `.csv`: a line of column names, by FindPointColumns(), among them optionally Label; or lines of three numbers
 *   without names. Separated by commas, semicolons or tabs, with quotes, by ReadDelimitedText().
 * - `.fcsv`: markups of 3D Slicer; RAS coordinates, the default of its older versions, become LPS.
 * - `.mrk.json`: likewise of its newer ones, by ReadMarkupsJson().
 * - `.vtp`: the points of VTK's polygonal data; those whose field array `SPACE` says RAS become LPS.
 *
 * Numbers have a decimal point, whatever the locale.
 * \throws std::runtime_error: no such file, missing columns, text in place of a number, a number that is not finite;
 * with line, column and value. */
PointFile
ReadPointFile(const std::string & path);
} // namespace tissue

#endif
