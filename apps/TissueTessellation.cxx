/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// From a segmented 3-D image of a tissue to the triangular mesh of all its cell walls.
#include "OutputFiles.h"
#include "ProgressBar.h"
#include "ReconstructionReport.h"
#include "TissueInput.h"
#include "TissueTessellationOptions.h"
#include "TissueTessellationVTKBridge.h"
#include "VTKFiles.h"
#include "WallMeshPicture.h"
#include "itkJunctionsToCellWallMeshFilter.h"

#include <itkMultiThreaderBase.h>
#include <itkTimeProbe.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>

namespace
{
using namespace tissue;

/** Everything that would make the outputs impossible, before the work. */
void
CheckOutputs(const TissueTessellationOptions & options)
{
  for (const std::string & path : options.Outputs())
  {
    OutputFiles::RequireWritable(path);
  }
  const std::string obstacle = options.picture.empty() ? std::string() : FindPictureObstacle();
  if (!obstacle.empty())
  {
    throw std::runtime_error("--picture: " + obstacle);
  }
}

void
WriteOutputs(const ReconstructionReport & report)
{
  const TissueTessellationOptions & options = report.options;
  const WallMesh &                  walls = report.reconstruction.walls;
  const std::vector<Cell> &         cells = report.input.junctions->GetJunctionSet().cells;
  OutputFiles                       files;
  const auto                        add = [&files](const std::string & path, const OutputFiles::Writer & write) {
    if (!path.empty())
    {
      files.Add(path, write);
    }
  };
  add(options.walls, [&](const std::string & path) { WriteXML(MakeWallPolyData(walls, cells), path); });
  add(options.complex,
      [&](const std::string & path) { WriteXML(MakeComplexGrid(report.reconstruction.tetrahedra, cells), path); });
  add(options.cells, [&](const std::string & path) { WriteXML(MakeCellGrid(walls, cells, report.check), path); });
  add(options.statistics, [&](const std::string & path) { WriteCSV(MakeCellTable(walls, cells, report.check), path); });
  add(options.picture, [&](const std::string & path) { WriteWallMeshPicture(walls, cells, path); });
  add(options.report, [&](const std::string & path) {
    std::ofstream file(path);
    file << ToJson(report).dump(2) << '\n';
    if (!file.flush())
    {
      throw std::runtime_error("cannot write " + path);
    }
  });
  files.Commit();
}

void
Run(const TissueTessellationOptions & options)
{
  CheckOutputs(options);
  if (options.threads > 0)
  {
    itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(options.threads);
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(options.threads);
  }
  ProgressBar       progress(options.isQuiet);
  const TissueInput input = ReadTissue(options, progress);

  const auto filter = itk::JunctionsToCellWallMeshFilter::New();
  filter->SetInput(input.junctions);
  filter->SetParameters(options.parameters);
  progress.Begin("Optimizing the complex");
  progress.Observe(filter);
  filter->Update();

  itk::TimeProbe probe;
  probe.Start();
  const TissueReconstruction & reconstruction = filter->GetOutput()->GetReconstruction();
  const auto                   numberOfVertices = static_cast<VertexId>(input.junctions->GetJunctionSet().cells.size());
  const CellSurfaceCheck       check = CheckCellSurfaces(reconstruction.walls, numberOfVertices);
  probe.Stop();

  const ReconstructionReport report{ options, input, reconstruction, check, probe.GetTotal() };
  progress.Begin("Writing");
  WriteOutputs(report);
  progress.End();
  for (const std::string & warning : input.warnings)
  {
    std::cerr << "TissueTessellation: warning: " << warning << '\n';
  }
  if (!options.isQuiet)
  {
    Print(report, std::cout);
  }
}
} // namespace

int
main(int argc, char ** argv)
{
  int        exitCode = EXIT_SUCCESS;
  const auto options = ParseCommandLine(argc, argv, exitCode);
  if (!options)
  {
    return exitCode;
  }
  try
  {
    Run(*options);
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << "TissueTessellation: " << error.GetDescription() << '\n';
    return EXIT_FAILURE;
  }
  catch (const std::exception & error)
  {
    std::cerr << "TissueTessellation: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return exitCode;
}
