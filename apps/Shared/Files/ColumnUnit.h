/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ColumnUnit_h
#define ColumnUnit_h

#include <string>

namespace tissue
{
/** The symbol of a unit of length as the report has it, of an image or of points: `µm` for "micrometres" and "um", `mm`
 * for "millimetres", `voxel` for "voxels", `unit` where it is not known; all others are symbols. */
std::string
LengthSymbol(const std::string & unit);

/** \brief The unit of a column of MakeCellTable, by its name: a power of a length, `°`, or empty for a number.
 *
 * \param length symbol of the unit of lengths: `Volume` is in `µm³`, `GaussianCurvature` in `1/µm²`. */
std::string
ColumnUnit(const std::string & column, const std::string & length);
} // namespace tissue

#endif
