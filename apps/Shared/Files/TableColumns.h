/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TableColumns_h
#define TableColumns_h

#include <string>
#include <vector>

class vtkAbstractArray;
class vtkTable;

namespace tissue
{
/** \brief A column of text or numbers for a file: an array of a table, or one component of it. */
struct TableColumn
{
  /** Of the array, with that of the component: `NormalX`. */
  std::string        name;
  vtkAbstractArray * array;
  int                component;
};

/** In the table's order. */
std::vector<TableColumn>
ListColumns(vtkTable * table);

enum class ValueType
{
  WholeNumber,
  Number,
  Text
};

ValueType
TypeOf(const TableColumn & column);

/** A value as it reads back: a floating-point number in the shortest form of all that do, empty where it is not known
 * (not a number). Text is as it is. */
std::string
ToText(const TableColumn & column, long long row);
} // namespace tissue

#endif
