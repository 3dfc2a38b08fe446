/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ReconstructionOutput.h"

#include "Shared/Files/GraphFile.h"
#include "Shared/Files/JsonFiles.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Files/VTKFiles.h"
#include "Shared/Pictures/WallMeshPicture.h"
#include "TissueTessellationVTKBridge.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

namespace tissue
{
namespace
{
/** Adds the column `Name` to those of cells, by their `Label`; none where there are no names. */
void
AddNames(vtkFieldData * columns, const std::map<Label, std::string> & names)
{
  if (names.empty())
  {
    return;
  }
  vtkDataArray * const         labels = columns->GetArray("Label");
  const vtkNew<vtkStringArray> column;
  column->SetName("Name");
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    const auto name = names.find(labels->GetVariantValue(i).ToTypeInt64());
    column->InsertNextValue(name == names.end() ? std::string() : name->second);
  }
  columns->AddArray(column);
}
} // namespace

void
WriteOutputs(const OutputPaths & paths, const ReconstructionReport & report, ProgressBar & progress)
{
  const TissueReconstruction & reconstruction = report.GetReconstruction();
  const WallMesh &             walls = reconstruction.walls;
  const CellSurfaceCheck &     check = report.tissue.check;
  const TissueStatistics &     statistics = report.tissue.statistics;
  const std::vector<Cell> &    cells = report.GetCells();
  OutputFiles                  files;
  const auto                   add = [&files](const std::string & path, const OutputFiles::Writer & write) {
    if (!path.empty())
    {
      files.Add(path, write);
    }
  };
  progress.Begin("Writing");
  add(paths.walls, [&](const std::string & path) { WriteXML(MakeWallPolyData(walls, cells, statistics), path); });
  add(paths.complex,
      [&](const std::string & path) { WriteXML(MakeComplexGrid(reconstruction.tetrahedra, cells), path); });
  add(paths.cells, [&](const std::string & path) {
    const auto grid = MakeCellGrid(walls, cells, check, statistics);
    AddNames(grid->GetCellData(), report.input.names);
    WriteXML(grid, path);
  });
  const auto makeCellTable = [&] {
    const auto table = MakeCellTable(walls, cells, check, statistics);
    AddNames(table->GetRowData(), report.input.names);
    return table;
  };
  add(paths.statistics, [&](const std::string & path) { WriteCSV(makeCellTable(), path); });
  add(paths.wallStatistics, [&](const std::string & path) { WriteCSV(MakeWallTable(walls, cells, statistics), path); });
  add(paths.graph,
      [&](const std::string & path) { WriteGraphML(makeCellTable(), MakeNeighborTable(walls, cells), path); });
  add(paths.junctions,
      [&](const std::string & path) { WriteCSV(MakeJunctionTable(report.input.GetJunctionSet()), path); });
  add(paths.picture, [&](const std::string & path) { WriteWallMeshPicture(walls, cells, path); });
  add(paths.report, [&](const std::string & path) { WriteJson(ToJson(report), path); });
  files.Commit();
  progress.End();
}
} // namespace tissue
