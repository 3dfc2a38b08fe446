/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef CellColumnNames_h
#define CellColumnNames_h

#include <string>
#include <vector>

namespace tissue
{
/** The columns of the statistics of cells, by their names in files. */
std::vector<std::string>
CellColumnNames();

/** These, and the names of all arrays of cells, which no other column may have. */
std::vector<std::string>
ReservedColumnNames();
} // namespace tissue

#endif
