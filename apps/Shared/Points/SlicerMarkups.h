/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SlicerMarkups_h
#define SlicerMarkups_h

#include "Shared/Points/PointFileReader.h"

#include <istream>

namespace tissue
{
/** The control points of all lists of points in a `.mrk.json`, the format of markups of 3D Slicer, in LPS.
 * \throws std::runtime_error: no such JSON, another kind of markup, an unknown coordinate system, a position that is
 * not defined or not of three finite numbers; with the number of markup and point, from 1 on. */
PointFile
ReadMarkupsJson(std::istream & stream);

/** Turns points from the system of that name, or of its number in Slicer, into LPS.
 * \throws std::runtime_error for all but LPS and RAS. */
void
TurnIntoLPS(const std::string & system, std::vector<Point> & points);
} // namespace tissue

#endif
