/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PlyPoints_h
#define PlyPoints_h

#include "Shared/Points/PointFileReader.h"

#include <istream>

namespace tissue
{
/** \brief The vertices of a `.ply`, text or binary of either byte order, in the coordinates of the file.
 *
 * VTK's reader ends the program where there is no z, and takes a file that is cut off for a whole one.
 * \throws std::runtime_error: no PLY, no vertices with x, y and z, lists before them, a file that is cut off, a number
 * that is none or not finite. */
PointFile
ReadPlyPoints(std::istream & stream);
} // namespace tissue

#endif
