/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "OutputFiles.h"
#include "ProgressBar.h"
#include "RunProgram.h"
#include "TissueInput.h"
#include "TissueTessellationCore/Voids.h"
#include "TissueTessellationCore/WallDistance.h"
#include "TissueTessellationCore/WallMeshEvaluation.h"
#include "VoxelDice.h"
#include "WallMeshInput.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <numeric>

namespace tissue
{
namespace
{
using Json = nlohmann::ordered_json;

struct Options
{
  TissueTessellationOptions input;
  std::string               mesh;
  std::string               labelArray = "BoundaryLabels";
  std::string               report;
};

/** All that is found of a mesh. */
struct Evaluation
{
  JunctionSet         junctions;
  WallMeshEvaluation  mesh;
  WallDistance        distance;
  std::vector<double> dice;
};

/** The volume with the voids counted to the exterior, as in the junctions. */
LabelVolume
WithoutVoids(LabelVolume volume, VertexId numberOfVertices)
{
  std::replace_if(
    volume.vertices.begin(),
    volume.vertices.end(),
    [numberOfVertices](VertexId v) { return v >= numberOfVertices; },
    ExteriorVertex);
  return volume;
}

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
  Evaluation        result;
  // A mesh of any origin knows one exterior.
  result.junctions = MergeVoids(input.junctions->GetJunctionSet());
  progress.Begin("Reading the mesh");
  const WallMesh walls = ReadWallMesh(options.mesh, options.labelArray, result.junctions);
  const auto     numberOfVertices = static_cast<VertexId>(result.junctions.cells.size());
  progress.Begin("Judging the mesh");
  const LabelVolume volume = WithoutVoids(*input.volume, numberOfVertices);
  result.mesh = EvaluateWallMesh(walls, result.junctions);
  result.distance = MeasureWallDistance(walls, numberOfVertices, volume);
  progress.Begin("Comparing voxels");
  result.dice = ComputeVoxelDice(walls, numberOfVertices, volume);
  progress.End();
  return result;
}

double
MeanDice(const Evaluation & e)
{
  return std::accumulate(e.dice.begin() + 1, e.dice.end(), 0.0) / static_cast<double>(e.mesh.numberOfCells);
}

Json
ToJson(const Evaluation & e)
{
  const WallMeshEvaluation & m = e.mesh;
  Json                       json{
    { "cells", m.numberOfCells },
    { "triangles", m.numberOfTriangles },
    { "trianglesPerCell", static_cast<double>(m.numberOfTriangles) / static_cast<double>(m.numberOfCells) },
    { "adjacency2", m.overlap.adjacency2 },
    { "adjacency4", m.overlap.adjacency4 },
    { "corners", m.numberOfCorners },
    { "cornersOfMoreThanFourCells", m.numberOfCrowdedCorners },
    { "missingCells", m.numberOfMissingCells },
    { "closedCells", m.numberOfClosedCells },
    { "spheres", m.numberOfSpheres },
    { "meanVolumeError", m.meanVolumeError },
    { "volumeErrorPercentile95", m.volumeErrorPercentile95 },
    { "shareWithinOnePercent", m.shareWithinOnePercent },
    { "wallDistance", e.distance.mean },
    { "wallDistanceInVoxels", e.distance.meanInVoxels },
    { "shareOfFalseWalls", e.distance.shareOfFalseWalls },
    { "quality",
                            { { "mean", m.quality.mean }, { "fifthPercentile", m.quality.fifthPercentile }, { "least", m.quality.least } } },
    { "degenerateTriangles", m.numberOfDegenerateTriangles },
    { "crossingPairs", m.numberOfCrossings },
    { "meanDice", MeanDice(e) },
    { "meanConvexity", m.meanConvexity }
  };
  const auto numberOrNull = [](double value) { return value < 0.0 ? Json() : Json(value); };
  for (std::size_t v = ExteriorVertex + 1; v < m.cells.size(); ++v)
  {
    const WallMeshEvaluation::Cell & cell = m.cells[v];
    json["byCell"].push_back({ { "label", e.junctions.cells[v].label },
                               { "isClosed", cell.isClosed },
                               { "eulerCharacteristic", cell.eulerCharacteristic },
                               { "volumeError", numberOrNull(cell.volumeError) },
                               { "wallDistance", e.distance.ofVertex[v] },
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
    return stream << std::left << std::setw(34) << name << std::right;
  };
  stream << std::setprecision(4);
  line("Triangles") << m.numberOfTriangles << ", "
                    << static_cast<double>(m.numberOfTriangles) / static_cast<double>(m.numberOfCells) << " a cell\n";
  line("Adjacency2, adjacency4") << m.overlap.adjacency2 << ", " << m.overlap.adjacency4 << '\n';
  line("Corners of more than four cells") << m.numberOfCrowdedCorners << " of " << m.numberOfCorners << '\n';
  line("Cells: closed, spheres, missing") << m.numberOfClosedCells << ", " << m.numberOfSpheres << ", "
                                          << m.numberOfMissingCells << " of " << m.numberOfCells << '\n';
  line("Volume error: mean, 95 %") << m.meanVolumeError << ", " << m.volumeErrorPercentile95 << "; "
                                   << m.shareWithinOnePercent << " of the cells within 1 %\n";
  line("Wall to the same wall") << e.distance.mean << ", in voxels " << e.distance.meanInVoxels << "; "
                                << e.distance.shareOfFalseWalls << " of the area in walls that the image has not\n";
  line("Quality: mean, 5 %, least") << m.quality.mean << ", " << m.quality.fifthPercentile << ", " << m.quality.least
                                    << "; degenerate " << m.numberOfDegenerateTriangles << '\n';
  line("Pairs of triangles that cross") << m.numberOfCrossings << '\n';
  line("Dice of voxels, convexity of cells") << MeanDice(e) << ", " << m.meanConvexity << '\n';
}

void
Run(const Options & options)
{
  if (!options.report.empty())
  {
    OutputFiles::RequireWritable(options.report);
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
    CLI::App        app("Judges a mesh of cell walls, of any origin, by the label image that it is of.");
    app.option_defaults()->always_capture_default();
    app.set_version_flag("--version", TISSUE_TESSELLATION_VERSION);
    app.add_option("MESH", options.mesh, "Triangles with two labels each (.vtp, .vtk)")->required();
    app.add_option("LABELS", options.input.labels, "The label image")->required();
    app.add_option("--report", options.report, "Write all figures, by cell too, to this file (.json)");
    app.add_option("--labelArray", options.labelArray, "Cell array of the mesh with the two labels of each triangle");
    app.add_option(
      "--exteriorLabel", options.input.exteriorLabel, "Label of the exterior; found in the image by default");
    app.add_flag("--zeroIsCell", options.input.zeroIsCell, "Take label 0 for a cell");
    app.add_option("--spacing", options.input.spacing, "Voxel size x y z in place of the image file's");
    app.add_flag("--quiet", options.input.isQuiet, "Say nothing but errors");
    try
    {
      app.parse(argc, argv);
    }
    catch (const CLI::Success & success)
    {
      app.exit(success);
      return;
    }
    catch (const CLI::Error & error)
    {
      throw std::runtime_error(std::string(error.what()) + " (--help lists the options)");
    }
    tissue::Run(options);
  });
}
