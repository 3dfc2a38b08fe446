/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointTable_h
#define PointTable_h

#include "Shared/Points/PointFileOptions.h"
#include "Shared/Points/PointFileReader.h"

#include <istream>

namespace tissue
{
/** \brief Reads a table of points as text: values of any separator, decimal sign and encoding under a line of names.
 *
 * By DecodeText(), ReadDelimitedText(), FindPointTableHeader(), DropSummaryRows() and FindPointColumns(). Three columns
 * may do without names. Rows have as many values as there are names; where each has one more the first is its name (as
 * of R). Labels are whole numbers from 0 on; where one is text they are names (PointFile::names), and rows are
 * numbered. \throws std::runtime_error that names line and column: what of these throws; rows of other numbers of
 * values; several time points, unless the options take one of them or all. */
PointFile
ReadPointTable(std::istream & stream, const PointFileOptions & options);
} // namespace tissue

#endif
