/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Projection/CellColumnNames.h"

#include "Shared/Files/TableColumns.h"
#include "TissueTessellationVTKBridge.h"

namespace tissue
{
namespace
{
/** Of a tissue without a cell: it has all columns. */
vtkSmartPointer<vtkTable>
MakeEmptyTable()
{
  const WallMesh          mesh;
  const std::vector<Cell> cells(1);
  return MakeCellTable(mesh, cells, CheckCellSurfaces(mesh, 1), MeasureTissue(mesh, cells, ImageGrid()));
}
} // namespace

std::vector<std::string>
CellColumnNames()
{
  const auto               table = MakeEmptyTable();
  std::vector<std::string> names;
  for (const TableColumn & column : ListColumns(table))
  {
    names.push_back(column.name);
  }
  return names;
}

std::vector<std::string>
ReservedColumnNames()
{
  std::vector<std::string> names = CellColumnNames();
  names.emplace_back("Name");
  const auto table = MakeEmptyTable();
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    names.emplace_back(table->GetColumnName(i));
  }
  return names;
}
} // namespace tissue
