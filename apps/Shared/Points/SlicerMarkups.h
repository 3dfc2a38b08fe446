/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SlicerMarkups_h
#define SlicerMarkups_h

#include "Shared/Points/PointFileReader.h"
#include "Shared/Points/PointFileWriter.h"

#include <istream>

namespace tissue
{
/** The control points of all lists of points in a `.mrk.json`, the format of markups of 3D Slicer, in LPS.
 *
 * Points of the `positionStatus` undefined, preview or missing, which have no place, are left out with a warning.
 * \throws std::runtime_error: no such JSON, another kind of markup, no or an unknown coordinate system, an unknown
 * status, a position that is not of three finite numbers; with the number of markup and point, from 1 on. */
PointFile
ReadMarkupsJson(std::istream & stream);

/** Writes the points as one list of markups of 3D Slicer, in LPS, for `.mrk.json`: the
 * `label` is the value of the column `Label`, or else the number from 1 on; the other columns are the `description`.
 * \throws std::runtime_error where it cannot. */
void
WriteMarkupsJson(const PointTable & table, const std::string & path);

/** Turns points from the system of that name, or of its number in Slicer, into LPS.
 * \throws std::runtime_error for all but LPS and RAS. */
void
TurnIntoLPS(const std::string & system, std::vector<Point> & points);
} // namespace tissue

#endif
