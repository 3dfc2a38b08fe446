/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef CellTable_h
#define CellTable_h

#include "TissueTessellationCore/Common/Types.h"

#include <istream>
#include <string>
#include <vector>

namespace tissue
{
/** Values of cells, a row each. */
struct CellTable
{
  /** Numbers, or else texts, one of each row. */
  struct Column
  {
    std::string name;
    /** Not a number where there is none. */
    std::vector<double>      numbers;
    std::vector<std::string> texts;
  };

  /** Of each row; empty where they are not all numbers. */
  std::vector<Label> labels;
  /** The same, as they are written. */
  std::vector<std::string> names;
  /** Of each row, where it is in the file. */
  std::vector<std::size_t> lines;
  std::vector<Column>      columns;
  /** Of what was left out. */
  std::vector<std::string> warnings;
};

/** \brief Reads a table of cells as text: values of any separator, decimal sign and encoding, as ReadPointTable() does,
 * under a line of names.
 *
 * One column has the labels, by RankCellName(), whole numbers from 0 on or names; all others with a name are values,
 * numbers or text. No number is an empty value, or "NA", "NaN", "null", "None" and alike.
 * \param labelColumn its name, or number from 1 on; empty: found by its name.
 * \throws std::runtime_error that names line and column: no rows, no column of labels or two, none of values, two of
 * one name, a label twice, text among numbers, a number that is not finite, rows of other numbers of values. */
CellTable
ReadCellTable(std::istream & stream, const std::string & labelColumn = std::string());
} // namespace tissue

#endif
