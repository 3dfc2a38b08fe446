/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/TableColumns.h"

#include <vtkDataArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <charconv>
#include <cmath>

namespace tissue
{
std::vector<TableColumn>
ListColumns(vtkTable * table)
{
  std::vector<TableColumn> columns;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray * const array = table->GetColumn(i);
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      const char * const of = array->GetComponentName(component);
      columns.push_back({ array->GetName() + std::string(of == nullptr ? "" : of), array, component });
    }
  }
  return columns;
}

ValueType
TypeOf(const TableColumn & column)
{
  if (vtkStringArray::SafeDownCast(column.array) != nullptr)
  {
    return ValueType::Text;
  }
  return column.array->GetDataType() == VTK_DOUBLE ? ValueType::Number : ValueType::WholeNumber;
}

std::string
ToText(const TableColumn & column, long long row)
{
  switch (TypeOf(column))
  {
    case ValueType::Text:
      return vtkStringArray::SafeDownCast(column.array)->GetValue(row);
    case ValueType::WholeNumber:
      return std::to_string(
        column.array->GetVariantValue(row * column.array->GetNumberOfComponents() + column.component).ToTypeInt64());
    default:
      break;
  }
  const double value = vtkDataArray::SafeDownCast(column.array)->GetComponent(row, column.component);
  if (std::isnan(value))
  {
    return {};
  }
  char       text[32];
  const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
  return { text, end };
}
} // namespace tissue
