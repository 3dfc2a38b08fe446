/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ReconstructionProgram.h"

#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Files/VTKFiles.h"
#include "Shared/Pictures/PictureObstacle.h"
#include "Shared/Pictures/WallMeshPicture.h"
#include "Shared/Reconstruction/ReconstructionReport.h"
#include "TissueTessellationVTKBridge.h"
#include "itkJunctionsToCellWallMeshFilter.h"

#include <itkMultiThreaderBase.h>
#include <itkTimeProbe.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>
#include <stdexcept>

namespace tissue
{
namespace
{
/** Throws for everything that would make the outputs impossible, before the work. */
void
CheckOutputs(const ReconstructionOptions & options)
{
  namespace fs = std::filesystem;
  std::set<fs::path> paths;
  for (const auto & [path, content] : options.Outputs())
  {
    OutputFiles::RequireWritable(path);
    for (const std::string & input : options.Inputs())
    {
      OutputFiles::RequireNotInput(path, input);
    }
    if (!paths.insert(fs::weakly_canonical(fs::absolute(path))).second)
    {
      throw std::runtime_error("Cannot write the " + content + " to '" + path + "': another output has the same name");
    }
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
  const ReconstructionOptions & options = report.options;
  const WallMesh &              walls = report.reconstruction.walls;
  const std::vector<Cell> &     cells = report.input.junctions->GetJunctionSet().cells;
  OutputFiles                   files;
  const auto                    add = [&files](const std::string & path, const OutputFiles::Writer & write) {
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
  add(options.junctions,
      [&](const std::string & path) { WriteCSV(MakeJunctionTable(report.input.junctions->GetJunctionSet()), path); });
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

/** What is made of the labels, with the time of the check. */
struct Result
{
  TissueInput                input;
  itk::CellWallMesh::Pointer mesh;
  CellSurfaceCheck           check;
  double                     checkSeconds = 0.0;
};

Result
Reconstruct(const ReconstructionOptions & options, const InputReader & readInput, ProgressBar & progress)
{
  Result result;
  result.input = readInput(progress);
  const auto filter = itk::JunctionsToCellWallMeshFilter::New();
  filter->SetInput(result.input.junctions);
  filter->SetParameters(options.parameters);
  filter->SetLabelVolume(result.input.volume);
  result.input.volume = nullptr;
  progress.Begin("Optimizing the complex");
  progress.Observe(filter);
  filter->Update();
  result.mesh = filter->GetOutput();

  itk::TimeProbe probe;
  probe.Start();
  const auto numberOfVertices = static_cast<VertexId>(result.input.junctions->GetJunctionSet().cells.size());
  result.check = CheckCellSurfaces(result.mesh->GetWallMesh(), numberOfVertices);
  probe.Stop();
  result.checkSeconds = probe.GetTotal();
  return result;
}

} // namespace

void
RunTissueProgram(const std::string & program, const ReconstructionOptions & options,
                 const nlohmann::ordered_json & optionsAsJson, const InputReader & readInput)
{
  CheckOutputs(options);
  if (options.threads > 0)
  {
    itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(options.threads);
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(options.threads);
  }
  ProgressBar  progress(options.isQuiet);
  const Result result = WithFileName(options.MainInput(), [&] { return Reconstruct(options, readInput, progress); });

  std::optional<Judge> judge;
  if (!options.evaluateAgainst.empty())
  {
    // Cells of the judge itself are known by their labels.
    std::error_code isOther;
    const bool      isItself = std::filesystem::equivalent(options.MainInput(), options.evaluateAgainst, isOther);
    judge = ReadJudge(options.evaluateAgainst,
                      result.input.junctions->GetJunctionSet().cells,
                      isItself || options.evaluateByLabel,
                      progress);
  }
  const ReconstructionReport report{ program,
                                     options,
                                     optionsAsJson,
                                     result.input,
                                     result.mesh->GetReconstruction(),
                                     result.check,
                                     result.checkSeconds,
                                     judge ? &*judge : nullptr };
  progress.Begin("Writing");
  WriteOutputs(report);
  progress.End();
  for (const std::string & warning : CollectWarnings(report))
  {
    std::cerr << program << ": warning: " << warning << '\n';
  }
  if (!options.isQuiet)
  {
    Print(report, std::cout);
  }
}
} // namespace tissue
