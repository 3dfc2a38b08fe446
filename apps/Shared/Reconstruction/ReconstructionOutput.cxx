/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ReconstructionOutput.h"

#include "Shared/Exports/MeshExport.h"
#include "Shared/Files/ColumnUnit.h"
#include "Shared/Files/GraphFile.h"
#include "Shared/Files/JsonFiles.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Files/VTKFiles.h"
#include "Shared/Page/PageFile.h"
#include "Shared/Pictures/WallMeshPicture.h"
#include "Shared/Reconstruction/CellSegmentation.h"
#include "Shared/Reconstruction/PictureColumn.h"
#include "Shared/Reconstruction/ReconstructionModule.h"
#include "Shared/Simulation/SimulationModel.h"
#include "TissueTessellationVTKBridge.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <filesystem>

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

void
AddSimulations(const std::vector<std::string> & models, const ReconstructionReport & report, OutputFiles & files)
{
  if (models.empty())
  {
    return;
  }
  const SimulationModel model(report.GetReconstruction().walls, report.GetCells(), report.tissue.check);
  for (const std::string & name : models)
  {
    if (IsGmshModel(name))
    {
      const std::string beside = GmshWallsBeside(name);
      const std::string merged = std::filesystem::path(beside).filename().string();
      files.Add(beside, [&](const std::string & path) { model.WriteGmshWalls(path); });
      files.Add(name, [&](const std::string & path) { model.WriteGmshModel(path, merged); });
    }
    else
    {
      files.Add(name, [&](const std::string & path) { model.WriteTetGenModel(path); });
    }
  }
}

std::map<Label, Color>
ColorByLabel(const WallMesh & walls, const std::vector<Cell> & cells)
{
  const std::vector<Color> colors = ChooseCellColors(walls, static_cast<VertexId>(cells.size()));
  std::map<Label, Color>   byLabel;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    byLabel[cells[v].label] = colors[v];
  }
  return byLabel;
}

/** The cells as a grid, or as a segmentation of 3D Slicer. */
void
AddCells(const std::string & path, const ReconstructionReport & report, OutputFiles & files)
{
  const WallMesh &          walls = report.GetReconstruction().walls;
  const std::vector<Cell> & cells = report.GetCells();
  const auto                grid = MakeCellGrid(walls, cells, report.tissue.check, report.tissue.statistics);
  // Names are text, which meshio does not read of grids.
  AddCellColumns(grid->GetCellData(), cells, report.projected, TextColumns::LeftOut);
  if (IsSegmentation(path))
  {
    const auto segmentation = MakeCellSegmentation(grid, ColorByLabel(walls, cells), report.input.names);
    files.AddWithPieces(path, [&](const std::string & temporary) { WriteXML(segmentation, temporary); });
    return;
  }
  files.Add(path, [&](const std::string & temporary) { WriteXML(grid, temporary); });
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
  add(paths.walls, [&](const std::string & path) {
    const auto triangles = MakeWallPolyData(walls, cells, statistics);
    AddWallColumns(triangles->GetCellData(), cells, report.projected);
    WriteXML(triangles, path);
  });
  add(paths.complex,
      [&](const std::string & path) { WriteXML(MakeComplexGrid(reconstruction.tetrahedra, cells), path); });
  if (!paths.cells.empty())
  {
    AddCells(paths.cells, report, files);
  }
  add(paths.cellSurfaces, [&](const std::string & path) {
    const auto surfaces = MakeCellSurfaces(walls, cells, check, statistics);
    AddNames(surfaces->GetCellData(), report.input.names);
    AddCellColumns(surfaces->GetCellData(), cells, report.projected);
    WriteXML(surfaces, path);
  });
  AddSimulations(paths.simulations, report, files);
  for (const std::string & name : paths.exports)
  {
    files.Add(name, [&](const std::string & path) {
      ExportMesh(walls, cells, paths.exportedCells, report.projected, name, path);
    });
  }
  const auto makeCellTable = [&] {
    const auto table = MakeCellTable(walls, cells, check, statistics);
    AddNames(table->GetRowData(), report.input.names);
    AddCellColumns(table->GetRowData(), cells, report.projected);
    return table;
  };
  add(paths.statistics, [&](const std::string & path) { WriteCSV(makeCellTable(), path); });
  add(paths.wallStatistics, [&](const std::string & path) {
    const auto table = MakeWallTable(walls, cells, statistics);
    AddWallColumns(table->GetRowData(), cells, report.projected);
    WriteCSV(table, path);
  });
  add(paths.graph, [&](const std::string & path) {
    const auto neighbors = MakeNeighborTable(walls, cells, statistics);
    AddNeighborColumns(neighbors->GetRowData(), walls, cells, statistics.walls, report.projected);
    WriteGraphML(makeCellTable(), neighbors, path);
  });
  add(paths.junctions,
      [&](const std::string & path) { WriteCSV(MakeJunctionTable(report.input.GetJunctionSet()), path); });
  const std::string & lengthUnit = report.input.image.unit.empty() ? report.input.pointUnit : report.input.image.unit;
  add(paths.page, [&](const std::string & path) {
    const std::vector<Color> colors = ChooseCellColors(walls, static_cast<VertexId>(cells.size()));
    WritePage({ walls, makeCellTable(), colors, ToJson(report), lengthUnit }, path);
  });
  add(paths.picture, [&](const std::string & path) {
    WallMeshPictureOptions options;
    options.lengthUnit = lengthUnit.empty() ? options.lengthUnit : LengthSymbol(lengthUnit);
    if (!paths.colorBy.empty())
    {
      options.values = MakePictureValues(makeCellTable(), paths.colorBy, cells, options.lengthUnit);
    }
    WriteWallMeshPicture(walls, cells, path, options);
  });
  add(paths.returnParameters, [&](const std::string & path) { WriteReturnParameters(CollectResults(report), path); });
  add(paths.report, [&](const std::string & path) { WriteJson(ToJson(report), path); });
  files.Commit();
  progress.End();
}
} // namespace tissue
