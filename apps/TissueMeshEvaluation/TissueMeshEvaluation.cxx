/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Images/VisitPixelType.h"
#include "Shared/Reconstruction/TissueInput.h"
#include "TissueMeshEvaluation/WallMeshReader.h"
#include "itkCellWallMeshEvaluationCalculator.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace tissue
{
namespace
{
using Json = nlohmann::ordered_json;

struct Options
{
  ReconstructionOptions input;
  std::string           mesh;
  std::string           labelArray = "BoundaryLabels";
  std::string           report;
};

/** All that is found of a mesh, by the cells of the image. */
struct Evaluation : TissueMeshEvaluation
{
  std::vector<Cell> imageCells;
};

TissueInput
ReadLabels(const Options & options, ProgressBar & progress)
{
  try
  {
    return ReadTissue(options.input, progress);
  }
  catch (const std::exception & error)
  {
    throw std::runtime_error(options.input.labels + ": " + ToMessage(error));
  }
}

Evaluation
Evaluate(const Options & options)
{
  ProgressBar       progress(options.input.isQuiet);
  const TissueInput input = ReadLabels(options, progress);
  progress.Begin("Reading the mesh");
  const auto triangles = std::make_shared<const TrianglesOfLabels>(ReadWallMesh(options.mesh, options.labelArray));
  progress.Begin("Judging the mesh");
  Evaluation result;
  VisitPixelType(input.componentType, [&](auto zero) {
    using ImageType = itk::Image<decltype(zero), 3>;
    const auto calculator = itk::CellWallMeshEvaluationCalculator<ImageType>::New();
    calculator->SetJunctions(input.junctions);
    calculator->SetLabelVolume(input.volume);
    calculator->SetTriangles(triangles);
    try
    {
      calculator->Compute();
    }
    catch (const itk::ExceptionObject & error)
    {
      throw std::runtime_error(options.mesh + ": " + ToMessage(error));
    }
    result = { calculator->GetEvaluation(), calculator->GetCells() };
  });
  progress.End();
  return result;
}

Json
ToJson(const Evaluation & e)
{
  const auto                 numberOrNull = [](double value) { return value < 0.0 ? Json() : Json(value); };
  const auto                 inVoxels = [&e](double distance) { return e.distance.InVoxels(distance); };
  const WallMeshEvaluation & m = e.mesh;
  Json                       json{
    { "cells", m.numberOfCells },
    { "triangles", m.numberOfTriangles },
    { "trianglesPerCell", e.TrianglesPerCell() },
    { "adjacency2", m.overlap.adjacency2 },
    { "adjacency4", m.overlap.adjacency4 },
    { "corners", m.numberOfCorners },
    { "cornersOfMoreThanFourCells", m.numberOfCrowdedCorners },
    { "missingCells", m.numberOfMissingCells },
    { "closedCells", m.numberOfClosedCells },
    { "spheres", m.numberOfSpheres },
    { "meanVolumeError", numberOrNull(m.meanVolumeError) },
    { "volumeErrorPercentile95", numberOrNull(m.volumeErrorPercentile95) },
    { "shareWithinOnePercent", m.shareWithinOnePercent },
    { "wallDistance", numberOrNull(e.distance.mean) },
    { "wallDistanceInVoxels", numberOrNull(inVoxels(e.distance.mean)) },
    { "shareOfFalseWalls", e.distance.shareOfFalseWalls },
    { "quality",
                            { { "mean", m.quality.mean }, { "fifthPercentile", m.quality.fifthPercentile }, { "least", m.quality.least } } },
    { "degenerateTriangles", m.numberOfDegenerateTriangles },
    { "crossingPairs", m.numberOfCrossings },
    { "meanDice", e.meanDice },
    { "meanConvexity", numberOrNull(m.meanConvexity) }
  };
  for (std::size_t v = ExteriorVertex + 1; v < m.cells.size(); ++v)
  {
    const WallMeshEvaluation::Cell & cell = m.cells[v];
    json["byCell"].push_back({ { "label", e.imageCells[v].label },
                               { "isClosed", cell.isClosed },
                               { "eulerCharacteristic", cell.eulerCharacteristic },
                               { "volumeError", numberOrNull(cell.volumeError) },
                               { "wallDistance", numberOrNull(e.distance.ofVertex[v]) },
                               { "wallDistanceInVoxels", numberOrNull(inVoxels(e.distance.ofVertex[v])) },
                               { "dice", e.dice[v] },
                               { "convexity", numberOrNull(cell.convexity) } });
  }
  return json;
}

void
Print(const Evaluation & e, std::ostream & stream)
{
  const WallMeshEvaluation & m = e.mesh;
  const auto                 line = [&stream](const char * name) -> std::ostream & {
    return stream << std::left << std::setw(36) << name << std::right;
  };
  const auto numberOrNone = [](double value) {
    std::ostringstream text;
    text << std::setprecision(4);
    value < 0.0 ? text << "none" : text << value;
    return text.str();
  };
  stream << std::setprecision(4);
  line("Triangles") << m.numberOfTriangles << ", " << e.TrianglesPerCell() << " a cell\n";
  line("Adjacency2, adjacency4") << m.overlap.adjacency2 << ", " << m.overlap.adjacency4 << '\n';
  line("Corners of more than four cells") << m.numberOfCrowdedCorners << " of " << m.numberOfCorners << '\n';
  line("Cells: closed, spheres, missing") << m.numberOfClosedCells << ", " << m.numberOfSpheres << ", "
                                          << m.numberOfMissingCells << " of " << m.numberOfCells << '\n';
  line("Volume error: mean, 95 %") << numberOrNone(m.meanVolumeError) << ", " << numberOrNone(m.volumeErrorPercentile95)
                                   << "; " << m.shareWithinOnePercent << " of the cells within 1 %\n";
  line("Wall to the same wall") << numberOrNone(e.distance.mean) << ", in voxels "
                                << numberOrNone(e.distance.InVoxels(e.distance.mean)) << "; "
                                << e.distance.shareOfFalseWalls << " of the area in walls that the image has not\n";
  line("Quality: mean, 5 %, least") << m.quality.mean << ", " << m.quality.fifthPercentile << ", " << m.quality.least
                                    << "; degenerate " << m.numberOfDegenerateTriangles << '\n';
  line("Pairs of triangles that cross") << m.numberOfCrossings << '\n';
  line("Dice of voxels, convexity of cells") << e.meanDice << ", " << numberOrNone(m.meanConvexity) << '\n';
}

void
Run(const Options & options)
{
  if (!options.report.empty())
  {
    OutputFiles::RequireWritable(options.report);
    OutputFiles::RequireNotInput(options.report, options.mesh);
    OutputFiles::RequireNotInput(options.report, options.input.labels);
  }
  if (options.input.threads > 0)
  {
    itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(options.input.threads);
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(options.input.threads);
  }
  const Evaluation evaluation = Evaluate(options);
  if (!options.report.empty())
  {
    OutputFiles files;
    files.Add(options.report, [&evaluation](const std::string & path) {
      std::ofstream file(path);
      file << ToJson(evaluation).dump(2) << '\n';
      if (!file.flush())
      {
        throw std::runtime_error("cannot write " + path);
      }
    });
    files.Commit();
  }
  if (!options.input.isQuiet)
  {
    Print(evaluation, std::cout);
  }
}
} // namespace
} // namespace tissue

int
main(int argc, char ** argv)
{
  return tissue::RunProgram("TissueMeshEvaluation", [&] {
    tissue::Options options;
    options.input.parameters.separateVoids = false; // a mesh of any origin knows one exterior
    CLI::App app("Judges a mesh of cell walls, of any origin, by the label image that it is of.");
    app.option_defaults()->always_capture_default();
    app.set_version_flag("--version", TISSUE_TESSELLATION_VERSION);
    app.add_option("MESH", options.mesh, "Triangles with two labels each (.vtp, .vtk)")->required();
    app.add_option("LABELS", options.input.labels, "The label image")->required();
    app.add_option("--report", options.report, "Write all figures, by cell too, to this file (.json)");
    app.add_option("--labelArray", options.labelArray, "Cell array of the mesh with the two labels of each triangle");
    app.add_option(
      "--exteriorLabel", options.input.exteriorLabel, "Label of the exterior; found in the image by default");
    app.add_flag("--zeroIsCell", options.input.zeroIsCell, "Take label 0 for a cell");
    app.add_option("--spacing", options.input.spacing, "Voxel size x y z in place of the image file's")
      ->check(tissue::InRange(1e-12, 1e12));
    app.add_option("--threads", options.input.threads, "Threads; 0: all cores. The result does not depend on it")
      ->check(CLI::Range(0, 1024));
    app.add_flag("--quiet", options.input.isQuiet, "Say nothing but errors");
    if (tissue::Parse(app, argc, argv))
    {
      tissue::Run(options);
    }
  });
}
