/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/PictureColumn.h"

#include "Shared/Files/ColumnUnit.h"
#include "Shared/Files/TableColumns.h"

#include <vtkDataArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <limits>
#include <map>

namespace tissue
{
std::optional<PictureValues>
MakePictureValues(vtkTable * table, const std::string & column, const std::vector<Cell> & cells,
                  const std::string & lengthUnit)
{
  const std::vector<TableColumn> columns = ListColumns(table);
  const auto                     find = [&columns](const std::string & name) {
    return std::find_if(columns.begin(), columns.end(), [&name](const TableColumn & c) { return c.name == name; });
  };
  const auto labels = find("Label");
  const auto found = find(column);
  if (column == "Label" || column == "Name" || found == columns.end())
  {
    return std::nullopt;
  }
  std::map<Label, std::size_t> vertexOf;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    vertexOf[cells[v].label] = v;
  }
  const std::string unit = ColumnUnit(column, lengthUnit);
  PictureValues     values{ column + (unit.empty() ? "" : " (" + unit + ")"), {}, {} };
  const bool        isText = TypeOf(*found) == ValueType::Text;
  values.numbers.resize(isText ? 0 : cells.size(), std::numeric_limits<double>::quiet_NaN());
  values.texts.resize(isText ? cells.size() : 0);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::size_t v = vertexOf.at(labels->array->GetVariantValue(row).ToTypeInt64());
    if (isText)
    {
      values.texts[v] = ToText(*found, row);
    }
    else
    {
      values.numbers[v] = vtkDataArray::SafeDownCast(found->array)->GetComponent(row, found->component);
    }
  }
  return values;
}
} // namespace tissue
