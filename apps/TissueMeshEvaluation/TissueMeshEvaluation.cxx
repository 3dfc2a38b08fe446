/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/CommandLine/RunOptions.h"
#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Files/JsonFiles.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Reconstruction/ExteriorOptions.h"
#include "Shared/Reconstruction/LabelImageInput.h"
#include "TissueMeshEvaluation/WallMeshReader.h"
#include "itkCellWallMeshEvaluationCalculator.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

namespace tissue
{
namespace
{
using Json = nlohmann::ordered_json;

struct Options
{
  LabelImageOptions image;
  std::string       mesh;
  std::string       labelArray;
  std::string       report;
  RunOptions        run;
};

/** All that is found of a mesh, by the cells of the image. */
struct Evaluation : TissueMeshEvaluation
{
  std::vector<Cell> imageCells;
};

void
AddOptions(CLI::App & app, Options & options)
{
  app.option_defaults()->always_capture_default();
  app.set_version_flag("--version", TISSUE_TESSELLATION_VERSION);
  app.add_option("MESH", options.mesh, "Polygons with the labels of their cells (.vtp, .vtu, .vtk, .obj, ...)")
    ->required();
  app.add_option("LABELS", options.image.file, "The label image")->required();
  app.add_option("--report", options.report, "Write all figures, by cell too, to this file (.json)");
  app.add_option(
    "--labelArray",
    options.labelArray,
    "Cell array of the mesh with the labels on both sides of its polygons, or of the cell that they are of, "
    "or two arrays, label1,label2; by default it is looked for: BoundaryLabels, FaceLabels, label1 and "
    "label2, Label, ...");
  AddExteriorOptions(app, "", options.image.exterior);
  AddSpeckOption(app, options.image.acceptsSpecks);
  AddImageOptions(app, options.image.input);
  AddRunOptions(app, options.run);
}

/** Throws for everything that would make the report impossible, before the work. */
void
RequireOutput(const Options & options)
{
  if (!options.report.empty())
  {
    OutputFiles::RequireWritable(options.report);
    OutputFiles::RequireNotInput(options.report, options.mesh);
    OutputFiles::RequireNotInput(options.report, options.image.file);
  }
}

/** The junctions and the labels of the image, of which a mesh of any origin knows one exterior. */
ExtractedJunctions
FindJunctions(const LabelImage & image, const LabelImageOptions & options, ProgressBar & progress)
{
  JunctionOptions junctionOptions;
  junctionOptions.exterior = options.exterior;
  junctionOptions.makesVolume = true;
  junctionOptions.acceptsSpecks = options.acceptsSpecks;
  return ExtractTissue(image, junctionOptions, progress).extracted;
}

std::shared_ptr<const TrianglesOfLabels>
ReadMesh(const Options & options, const JunctionSet & junctions, ProgressBar & progress)
{
  progress.Begin("Reading the mesh");
  WallMeshFile file = ReadWallMesh(options.mesh, options.labelArray, junctions.exteriorLabels);
  progress.End();
  for (const std::string & warning : file.warnings)
  {
    std::cerr << "TissueMeshEvaluation: warning: " << options.mesh << ": " << warning << '\n';
  }
  return std::make_shared<const TrianglesOfLabels>(std::move(file.mesh));
}

/** \param meshFile the triangles' file, for messages. */
Evaluation
Evaluate(const ExtractedJunctions & extracted, const std::shared_ptr<const TrianglesOfLabels> & triangles,
         const std::string & meshFile, ProgressBar & progress)
{
  progress.Begin("Judging the mesh");
  // Any type of image will do: the junctions and the label volume stand for it.
  const auto calculator = itk::CellWallMeshEvaluationCalculator<itk::Image<std::uint32_t, 3>>::New();
  calculator->SetJunctions(extracted.junctions);
  calculator->SetLabelVolume(extracted.volume);
  calculator->SetTriangles(triangles);
  WithFileName(meshFile, [&] { calculator->Compute(); });
  return { calculator->GetEvaluation(), calculator->GetCells() };
}

Json
ToJson(const SurfaceTopology & topology)
{
  const auto ifClosed = [&topology](std::int64_t value) { return topology.isClosed ? Json(value) : Json(); };
  return { { "isClosed", topology.isClosed },
           { "pieces", ifClosed(topology.numberOfPieces) },
           { "eulerCharacteristic", ifClosed(topology.eulerCharacteristic) },
           { "genus", ifClosed(topology.Genus()) } };
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
    { "adjacency4OfNeighbors", m.overlap.adjacency4OfNeighbors },
    { "falsePairs", m.overlap.numberOfFalsePairs },
    { "missingPairs", m.overlap.numberOfMissingPairs },
    { "separateWalls",
                            { { "pairs", e.separateWalls.numberOfPairs }, { "keptPairs", e.separateWalls.numberOfKeptPairs } } },
    { "exterior", { { "image", ToJson(e.exteriorOfImage) }, { "mesh", ToJson(e.exteriorOfMesh) } } },
    { "corners", m.numberOfCorners },
    { "cornersOfMoreThanFourCells", m.numberOfCrowdedCorners },
    { "missingCells", m.numberOfMissingCells },
    { "closedCells", m.numberOfClosedCells },
    { "cellsOfSpheres", m.numberOfCellsOfSpheres },
    { "spheres", m.numberOfSpheres },
    { "meanVolumeError", numberOrNull(m.meanVolumeError) },
    { "volumeErrorPercentile95", numberOrNull(m.volumeErrorPercentile95) },
    { "shareWithinOnePercent", m.shareWithinOnePercent },
    { "wallDistance", numberOrNull(e.distance.mean) },
    { "wallDistanceInVoxels", numberOrNull(inVoxels(e.distance.mean)) },
    { "wallDistanceFromImage", numberOrNull(e.distance.meanFromImage) },
    { "wallDistanceFromImageInVoxels", numberOrNull(inVoxels(e.distance.meanFromImage)) },
    { "hausdorffDistance95", numberOrNull(e.distance.percentile95) },
    { "hausdorffDistance95InVoxels", numberOrNull(inVoxels(e.distance.percentile95)) },
    { "shareOfMissingWalls", e.distance.shareOfMissingWalls },
    { "shareOfFalseWalls", e.distance.shareOfFalseWalls },
    { "quality",
                            { { "mean", m.quality.mean }, { "fifthPercentile", m.quality.fifthPercentile }, { "least", m.quality.least } } },
    { "minimumTriangleAngle", m.angles.minimumTriangleAngle },
    { "minimumDihedralAngle", m.angles.minimumDihedralAngle },
    { "edgeLengthRatio", m.angles.EdgeLengthRatio() },
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
                               { "pieces", cell.numberOfPieces },
                               { "hasOnlySpheres", cell.hasOnlySpheres },
                               { "eulerCharacteristic", cell.eulerCharacteristic },
                               { "volumeError", numberOrNull(cell.volumeError) },
                               { "wallDistance", numberOrNull(e.distance.ofVertex[v]) },
                               { "wallDistanceInVoxels", numberOrNull(inVoxels(e.distance.ofVertex[v])) },
                               { "minimumDihedralAngle", m.angles.minimumDihedralOfCell[v] },
                               { "dice", e.dice[v] },
                               { "convexity", numberOrNull(cell.convexity) } });
  }
  return json;
}

/** Pieces and genus of a boundary, for a person. */
std::string
Describe(const SurfaceTopology & topology)
{
  return topology.isClosed
           ? "genus " + std::to_string(topology.Genus()) + " in " + std::to_string(topology.numberOfPieces) +
               (topology.numberOfPieces == 1 ? " piece" : " pieces")
           : "not closed";
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
  line("Adjacency2, adjacency4") << m.overlap.adjacency2 << ", " << m.overlap.adjacency4 << "; of neighbours "
                                 << m.overlap.adjacency4OfNeighbors << '\n';
  line("Pairs of neighbours: false, missing")
    << m.overlap.numberOfFalsePairs << ", " << m.overlap.numberOfMissingPairs << '\n';
  line("Pairs with separate walls: kept")
    << e.separateWalls.numberOfKeptPairs << " of " << e.separateWalls.numberOfPairs << '\n';
  line("Exterior: in the image, in the mesh")
    << Describe(e.exteriorOfImage) << ", " << Describe(e.exteriorOfMesh) << '\n';
  line("Corners of more than four cells") << m.numberOfCrowdedCorners << " of " << m.numberOfCorners << '\n';
  line("Cells: closed, of spheres, missing")
    << m.numberOfClosedCells << ", " << m.numberOfCellsOfSpheres << " (" << m.numberOfSpheres << " of one), "
    << m.numberOfMissingCells << " of " << m.numberOfCells << '\n';
  line("Volume error: mean, 95 %") << numberOrNone(m.meanVolumeError) << ", " << numberOrNone(m.volumeErrorPercentile95)
                                   << "; " << m.shareWithinOnePercent << " of the cells within 1 %\n";
  line("Wall to the same wall") << numberOrNone(e.distance.mean) << ", in voxels "
                                << numberOrNone(e.distance.InVoxels(e.distance.mean)) << "; "
                                << e.distance.shareOfFalseWalls << " of the area in walls that the image has not\n";
  line("Image's wall to it, 95 % both ways")
    << numberOrNone(e.distance.meanFromImage) << ", in voxels "
    << numberOrNone(e.distance.InVoxels(e.distance.meanFromImage)) << "; " << numberOrNone(e.distance.percentile95)
    << ", in voxels " << numberOrNone(e.distance.InVoxels(e.distance.percentile95)) << "; "
    << e.distance.shareOfMissingWalls << " of the image's faces in walls that the mesh has not\n";
  line("Quality: mean, 5 %, least") << m.quality.mean << ", " << m.quality.fifthPercentile << ", " << m.quality.least
                                    << "; degenerate " << m.numberOfDegenerateTriangles << '\n';
  line("Least angle: triangle, dihedral")
    << m.angles.minimumTriangleAngle << ", " << m.angles.minimumDihedralAngle << " degrees; longest edge "
    << m.angles.EdgeLengthRatio() << " times the shortest\n";
  line("Pairs of triangles that cross") << m.numberOfCrossings << '\n';
  line("Dice of voxels, convexity of cells") << e.meanDice << ", " << numberOrNone(m.meanConvexity) << '\n';
}

void
WriteReport(const Evaluation & evaluation, const std::string & report)
{
  if (!report.empty())
  {
    OutputFiles files;
    files.Add(report, [&evaluation](const std::string & path) { WriteJson(ToJson(evaluation), path); });
    files.Commit();
  }
}
} // namespace
} // namespace tissue

int
main(int argc, char ** argv)
{
  using namespace tissue;
  return RunProgram("TissueMeshEvaluation", [&] {
    Options  options;
    CLI::App app("Judges a mesh of cell walls, of any origin, by the label image that it is of.");
    AddOptions(app, options);
    if (!Parse(app, argc, argv))
    {
      return;
    }
    RequireOutput(options);
    UseThreads(options.run.threads);
    ProgressBar progress(options.run.GetProgressStyle());

    const LabelImage image = ReadLabelImage(options.image, progress);
    for (const std::string & warning : image.warnings)
    {
      std::cerr << "TissueMeshEvaluation: warning: " << options.image.file << ": " << warning << '\n';
    }
    const auto       extracted = FindJunctions(image, options.image, progress);
    const auto       triangles = ReadMesh(options, extracted.junctions->GetJunctionSet(), progress);
    const Evaluation evaluation = Evaluate(extracted, triangles, options.mesh, progress);
    progress.End();
    WriteReport(evaluation, options.report);
    if (!options.run.isQuiet)
    {
      Print(evaluation, std::cout);
    }
  });
}
