/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TableRows_h
#define TableRows_h

#include "Shared/Points/DelimitedText.h"
#include "Shared/Points/PointTableHeader.h"

#include <vector>

namespace tissue
{
/** \brief Makes sure that the rows of a table, of which there are some, have as many values as there are names.
 *
 * Where each has one more the first is its name, as of R: an empty name is put before the others, with a warning.
 * \throws std::runtime_error that names the line of a row with another number of values. */
void
MatchNames(const std::vector<DelimitedText::Record> & rows, PointTableHeader & header);
} // namespace tissue

#endif
