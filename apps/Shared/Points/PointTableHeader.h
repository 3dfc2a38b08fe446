/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointTableHeader_h
#define PointTableHeader_h

#include "Shared/Points/DelimitedText.h"
#include "Shared/Points/PointFileOptions.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tissue
{
/** What is before the rows of a table. */
struct PointTableHeader
{
  /** Of the columns; empty where they have none. */
  std::vector<std::string> names;
  /** Of the names, or of the first row where there are none. */
  std::size_t line = 0;
  /** The index of the first record that is a row. */
  std::size_t firstRow = 0;
  /** Of lines that are left out. */
  std::vector<std::string> warnings;
};

/** \brief Finds the names of a table's columns, and its first row.
 *
 * The names are in the first line that has some of coordinates, by HasPointColumns(), or in a comment before the rows.
 * Lines of names or units above it and below, as TrackMate and Mastodon write, belong to them: a unit is added to the
 * name
 * ("POSITION_X (micron)"). Titles above are left out, with a warning where they are more than one text. Without names
 * the first lines are left out, with a warning, where they have text in a column that has numbers in all other lines.
 * \param text has records.
 * \throws std::runtime_error: no line of the first is behind the end; numbers of columns in which no line has numbers;
 * a first row without names that may be no row: 0, 1, 2, and in columns by number one of whole numbers alone. */
PointTableHeader
FindPointTableHeader(const DelimitedText & text, const PointFileOptions & options);

/** Whether it is a number, with a decimal point or comma. */
bool
LooksLikeNumber(const std::string & text);

/** "line 3" or "lines 3 and 7". */
std::string
NameLines(const std::vector<std::size_t> & lines);
} // namespace tissue

#endif
