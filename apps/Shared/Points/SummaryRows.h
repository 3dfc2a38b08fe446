/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SummaryRows_h
#define SummaryRows_h

#include "Shared/Points/DelimitedText.h"

#include <string>
#include <vector>

namespace tissue
{
/** \brief Drops the rows of a summary at the end of a table: "Mean", "StdDev", "Min" and alike in any column.
 *
 * They are such where one of them at least is a mean, a deviation or a median, or none has the numbers of a point. In a
 * table with such words in most rows they are something else. Returns a warning of what is dropped.
 * \throws std::runtime_error that names the line: a mean or deviation before the end, and other words alone at the end
 * with numbers. */
std::vector<std::string>
DropSummaryRows(std::vector<DelimitedText::Record> & rows);
} // namespace tissue

#endif
