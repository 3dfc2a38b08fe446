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
/** The symbol of a unit of length: `µm` for "micrometres", `mm` for "millimetres", itself for all others that are not
 * empty, and `unit` where it is not known. */
std::string
LengthSymbol(const std::string & unit);

/** \brief The unit of a column of MakeCellTable, by its name: a power of a length, `°`, or empty for a number.
 *
 * \param length symbol of the unit of lengths: `Volume` is in `µm³`, `GaussianCurvature` in `µm⁻²`. */
std::string
ColumnUnit(const std::string & column, const std::string & length);
} // namespace tissue

#endif
