/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ReconstructionOutput.h"

#include "Shared/Files/JsonFiles.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Files/VTKFiles.h"
#include "Shared/Pictures/WallMeshPicture.h"
#include "TissueTessellationVTKBridge.h"

namespace tissue
{
void
WriteOutputs(const OutputPaths & paths, const ReconstructionReport & report, ProgressBar & progress)
{
  const TissueReconstruction & reconstruction = report.GetReconstruction();
  const WallMesh &             walls = reconstruction.walls;
  const CellSurfaceCheck &     check = report.tissue.check;
  const std::vector<Cell> &    cells = report.GetCells();
  OutputFiles                  files;
  const auto                   add = [&files](const std::string & path, const OutputFiles::Writer & write) {
    if (!path.empty())
    {
      files.Add(path, write);
    }
  };
  progress.Begin("Writing");
  add(paths.walls, [&](const std::string & path) { WriteXML(MakeWallPolyData(walls, cells), path); });
  add(paths.complex,
      [&](const std::string & path) { WriteXML(MakeComplexGrid(reconstruction.tetrahedra, cells), path); });
  add(paths.cells, [&](const std::string & path) { WriteXML(MakeCellGrid(walls, cells, check), path); });
  add(paths.statistics, [&](const std::string & path) { WriteCSV(MakeCellTable(walls, cells, check), path); });
  add(paths.junctions,
      [&](const std::string & path) { WriteCSV(MakeJunctionTable(report.input.GetJunctionSet()), path); });
  add(paths.picture, [&](const std::string & path) { WriteWallMeshPicture(walls, cells, path); });
  add(paths.report, [&](const std::string & path) { WriteJson(ToJson(report), path); });
  files.Commit();
  progress.End();
}
} // namespace tissue
