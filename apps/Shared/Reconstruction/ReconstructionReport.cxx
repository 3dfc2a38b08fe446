/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ReconstructionReport.h"

#include "TissueTessellationCore/Geometry/TriangleQuality.h"

#include <itkMultiThreaderBase.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <map>

namespace tissue
{
namespace
{
using Json = nlohmann::ordered_json;

/** Points alone have no walls, lines and junctions in an image, and no volumes, to compare with. */
bool
HasLabelImage(const ReconstructionReport & report)
{
  return !report.input.junctions->GetJunctionSet().walls.empty();
}

/** Whether the voxels of an image are known: of the label image, or of that of the nuclei. */
bool
HasVoxels(const ReconstructionReport & report)
{
  return report.input.size[0] > 0;
}

/** Null where it is not known. */
template <typename T>
Json
ToJsonIf(bool isKnown, const T & value)
{
  return isKnown ? Json(value) : Json();
}

Json
ToJson(const ReconstructionStage & stage, bool hasLabelImage)
{
  const ComplexStatistics & s = stage.statistics;
  return { { "adjacency2", ToJsonIf(hasLabelImage, s.adjacency2) },
           { "adjacency4", ToJsonIf(hasLabelImage, s.adjacency4) },
           { "neighborhoodError", s.neighborhoodError },
           { "eccentricity", s.eccentricity },
           { "minimalDihedralAngle", s.minimalDihedralAngle },
           { "maximalDihedralAngle", s.maximalDihedralAngle },
           { "tetrahedra", s.numberOfTetrahedra },
           { "edges", s.numberOfEdges },
           { "innerTetrahedra", s.numberOfInnerTetrahedra },
           { "invertedTetrahedra", s.numberOfInvertedTetrahedra },
           { "epidermalCells", s.numberOfEpidermalCells } };
}

std::vector<Label>
LabelsOf(const std::vector<VertexId> & vertices, const std::vector<Cell> & cells)
{
  std::vector<Label> labels;
  for (const VertexId v : vertices)
  {
    labels.push_back(cells[v].label);
  }
  return labels;
}

/** What is to be said of one cell. */
struct Note
{
  Label       label;
  std::string reason;
  double      value;
  std::string text;
};

/** The remarks on cells, and those that the check of the mesh adds. */
std::vector<Note>
CollectNotes(const ReconstructionReport & report)
{
  const std::vector<Cell> & cells = report.input.junctions->GetJunctionSet().cells;
  std::vector<Note>         notes;
  for (const Label label : LabelsOf(report.check.cellsWithoutTriangles, cells))
  {
    notes.push_back({ label, "missing", 0.0, "is missing from the mesh" });
  }
  for (const VertexId v : report.check.cellsThatAreNoSphere)
  {
    const auto characteristic = report.check.cells[v].eulerCharacteristic;
    notes.push_back(
      { cells[v].label,
        "noClosedSphere",
        static_cast<double>(characteristic),
        "has a surface that is no closed sphere; its Euler characteristic is " + std::to_string(characteristic) });
  }
  for (const CellRemark & remark : report.reconstruction.remarks)
  {
    notes.push_back({ cells[remark.cell].label, ToString(remark.remark), remark.value, Describe(remark) });
  }
  return notes;
}

/** Mean of the cells' relative difference from their volume in the image. */
double
MeanVolumeError(const ReconstructionReport & report)
{
  const std::vector<Cell> & cells = report.input.junctions->GetJunctionSet().cells;
  double                    sum = 0.0;
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    sum += std::abs(report.check.cells[v].volume / cells[v].volume - 1.0);
  }
  return sum / static_cast<double>(cells.size() - 1);
}

Json
MeshToJson(const ReconstructionReport & report)
{
  const WallMesh &          mesh = report.reconstruction.walls;
  const CellSurfaceCheck &  check = report.check;
  const std::vector<Cell> & cells = report.input.junctions->GetJunctionSet().cells;
  const QualitySummary      quality = SummarizeTriangleQuality(mesh.points, mesh.triangles);
  return { { "points", mesh.points.size() },
           { "triangles", mesh.triangles.size() },
           { "parts", report.reconstruction.numberOfParts },
           { "voids", report.reconstruction.numberOfVoids },
           { "walls", mesh.walls.size() },
           { "fitted", report.reconstruction.isFitted },
           { "cornersNotFitted", report.reconstruction.fitting.unfittedCorners },
           { "untangledPairs", report.reconstruction.fitting.untangledPairs },
           { "crossingPairs", report.reconstruction.fitting.crossingPairs },
           { "starWalls", report.reconstruction.fitting.starWalls },
           { "meanVolumeError", HasLabelImage(report) ? Json(MeanVolumeError(report)) : Json() },
           { "triangleQuality",
             { { "mean", quality.mean }, { "fifthPercentile", quality.fifthPercentile }, { "least", quality.least } } },
           { "trianglesPerCell", static_cast<double>(mesh.triangles.size()) / static_cast<double>(cells.size() - 1) },
           { "pointsWithMoreThanFourCells", check.crowdedPoints.size() },
           { "degenerateTriangles", check.numberOfDegenerateTriangles },
           { "cellsWithoutTriangles", LabelsOf(check.cellsWithoutTriangles, cells) },
           { "cellsThatAreNoClosedSphere", LabelsOf(check.cellsThatAreNoSphere, cells) } };
}

Json
EvaluationToJson(const ReconstructionReport & report)
{
  const StageEvaluation evaluation = EvaluateStages(report.reconstruction, *report.judge);
  const auto            toJson = [](const AdjacencyOverlap & overlap) {
    return Json{ { "adjacency2", overlap.adjacency2 }, { "adjacency4", overlap.adjacency4 } };
  };
  return { { "against", report.options.evaluateAgainst },
           { "cellsWithoutCounterpart", report.judge->numberOfUnknownCells },
           { "missedCells", report.judge->numberOfMissedCells },
           { "delaunay", toJson(evaluation.delaunay) },
           { "cleaned", toJson(evaluation.cleaned) },
           { "optimized", toJson(evaluation.optimized) } };
}

Json
SecondsToJson(const ReconstructionReport & report)
{
  const TissueReconstruction & r = report.reconstruction;
  // With the threads that the times are for: nothing else in the report depends on them.
  return { { "threads", itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads() },
           { "read", report.input.readSeconds },
           { "closeGaps", report.input.closeGapsSeconds },
           { "segmentation", report.input.segmentSeconds },
           { "extractJunctions", report.input.extractSeconds },
           { "delaunay", r.delaunay.seconds },
           { "cleanUp", r.cleaned.seconds },
           { "optimization", r.optimized.seconds },
           { "dual", r.dualSeconds },
           { "check", report.checkSeconds } };
}
} // namespace

Json
ToJson(const ReconstructionReport & report)
{
  const TissueReconstruction & r = report.reconstruction;
  const JunctionSet &          junctions = report.input.junctions->GetJunctionSet();
  const bool                   hasLabelImage = HasLabelImage(report);
  const bool                   hasVoxels = HasVoxels(report);
  Json                         json;
  json["program"] = { { "name", report.program }, { "version", TISSUE_TESSELLATION_VERSION } };
  json["input"] = { { "file", report.options.MainInput() },
                    { "points", report.input.numberOfPoints },
                    { "pixelType", ToJsonIf(!report.input.pixelType.empty(), report.input.pixelType) },
                    { "size", ToJsonIf(hasVoxels, report.input.size) },
                    { "spacing", ToJsonIf(hasVoxels, report.input.spacing) },
                    { "exteriorLabel", report.input.exteriorLabel },
                    { "cells", junctions.cells.size() - 1 },
                    { "voids", ToJsonIf(hasLabelImage, junctions.voids.size()) },
                    { "walls", ToJsonIf(hasLabelImage, junctions.walls.size()) },
                    { "tripleLines", ToJsonIf(hasLabelImage, junctions.tripleLines.size()) },
                    { "junctions", ToJsonIf(hasLabelImage, junctions.junctions.size()) },
                    { "blocksOfMoreThanFourCells", ToJsonIf(hasLabelImage, junctions.numberOfCrowdedBlocks) },
                    { "closedGaps",
                      { { "width", report.input.closedGapWidth },
                        { "voxels", report.input.numberOfClosedVoxels },
                        { "largestDistance", report.input.largestClosedDistance } } } };
  json["options"] = report.optionsAsJson;
  json["stages"] = { { "delaunay", ToJson(r.delaunay, hasLabelImage) },
                     { "cleaned", ToJson(r.cleaned, hasLabelImage) },
                     { "optimized", ToJson(r.optimized, hasLabelImage) } };
  if (report.judge != nullptr)
  {
    json["evaluation"] = EvaluationToJson(report);
  }
  json["cleanUp"] = { { "maximumEdgeLength", r.maximumEdgeLength },
                      { "triangleSwaps", r.cleanUp.numberOfSwaps },
                      { "edgeRemovals", r.cleanUp.numberOfRemovals } };
  json["cycles"] = Json::array();
  for (const AnnealingCycle & cycle : r.cycles)
  {
    json["cycles"].push_back({ { "temperature", cycle.temperature },
                               { "edgeRemovals", cycle.numberOfRemovals },
                               { "triangleSwaps", cycle.numberOfSwaps },
                               { "energy", cycle.energy } });
  }
  json["relocatedVertices"] = r.numberOfRelocatedVertices;
  json["energy"] = r.energy;
  json["mesh"] = MeshToJson(report);
  json["warnings"] = CollectWarnings(report);
  json["remarks"] = Json::array();
  for (const Note & note : CollectNotes(report))
  {
    json["remarks"].push_back(
      { { "label", note.label }, { "reason", note.reason }, { "value", note.value }, { "text", note.text } });
  }
  json["seconds"] = SecondsToJson(report);
  return json;
}

std::vector<std::string>
CollectWarnings(const ReconstructionReport & report)
{
  const CellSurfaceCheck &  check = report.check;
  const std::vector<Cell> & cells = report.input.junctions->GetJunctionSet().cells;
  std::vector<std::string>  warnings = report.input.warnings;
  const auto                addCells = [&](const std::vector<VertexId> & vertices, const std::string & what) {
    if (!vertices.empty())
    {
      warnings.push_back(std::to_string(vertices.size()) + (vertices.size() == 1 ? " cell " : " cells ") + what +
                         " (labels " + NameLabels(LabelsOf(vertices, cells)) + ")");
    }
  };
  addCells(check.cellsWithoutTriangles, "of the image are missing from the mesh");
  addCells(check.cellsThatAreNoSphere, "have a surface that is no closed sphere");
  if (!check.crowdedPoints.empty())
  {
    warnings.push_back("at " + std::to_string(check.crowdedPoints.size()) +
                       " points of the mesh more than four cells meet");
  }
  return warnings;
}

namespace
{
void
PrintEvaluation(const ReconstructionReport & report, std::ostream & stream)
{
  const StageEvaluation evaluation = EvaluateStages(report.reconstruction, *report.judge);
  stream << "Agreement with " << report.options.evaluateAgainst << ", adjacency2 / adjacency4: " << std::fixed
         << std::setprecision(4);
  const auto stage = [&stream](const char * name, const AdjacencyOverlap & overlap, const char * end) {
    stream << name << ' ' << overlap.adjacency2 << " / " << overlap.adjacency4 << end;
  };
  stage("Delaunay", evaluation.delaunay, ", ");
  stage("cleaned", evaluation.cleaned, ", ");
  stage("optimized", evaluation.optimized, "\n");
}

void
PrintStages(const TissueReconstruction & r, bool hasLabelImage, std::ostream & stream)
{
  const char * const agreement = hasLabelImage ? " adjacency2 adjacency4" : "";
  if (hasLabelImage)
  {
    stream << "Agreement with the image, 1 at best: adjacency2 by pairs of neighbours, adjacency4 by corners of four "
              "cells\n";
  }
  stream << "           " << agreement << "  neighbourhood  eccentricity  min. angle  max. angle   seconds\n"
         << std::fixed;
  const auto row = [&](const char * name, const ReconstructionStage & stage) {
    const ComplexStatistics & s = stage.statistics;
    stream << std::left << std::setw(11) << name << std::right;
    if (hasLabelImage)
    {
      stream << std::setprecision(4) << std::setw(11) << s.adjacency2 << std::setw(11) << s.adjacency4;
    }
    stream << std::setprecision(3) << std::setw(15) << s.neighborhoodError << std::setw(14) << s.eccentricity
           << std::setprecision(1) << std::setw(12) << s.minimalDihedralAngle << std::setw(12) << s.maximalDihedralAngle
           << std::setprecision(3) << std::setw(10) << stage.seconds << '\n';
  };
  row("Delaunay", r.delaunay);
  row("cleaned", r.cleaned);
  row("optimized", r.optimized);
}

/** A remark in words, after the number of the cells that it is on. */
std::string
DescribeReason(const std::string & reason)
{
  static const std::map<std::string, std::string> words{
    { "missing", "missing from the mesh" },
    { "noClosedSphere", "with a surface that is no closed sphere" },
    { "severalPieces", "in several pieces; the largest counts" },
    { "cutByBorder", "on the border of the image, where they may be cut" },
    { "enclosed", "enclosed in one other cell" },
    { "separated", "without a neighbour in the image" },
    { "strayPart", "in small parts that touch no other, joined to the nearest part by false walls" },
    { "separateWalls", "with several separate walls to one neighbour in the image; the mesh has one" },
    { "exteriorOnTwoSides", "at the exterior on two sides in the image; the mesh has one" },
    { "volumeOff", "with less than half or more than twice their volume in the image" },
    { "cornersNotFitted", "with corners that the image has not" },
    { "volumeNotFitted", "more than 1 % off their volume in the image, as their walls cannot move further" },
    { "centerMoved", "moved, their centre being another cell's too" },
    { "exteriorLost", "at the exterior in the image, but not in the mesh" },
    { "exteriorGained", "at the exterior in the mesh, but not in the image" },
    { "wallsLost", "without some wall that they have in the image" },
    { "wallsGained", "with some wall that they do not have in the image" },
  };
  const auto found = words.find(reason);
  return found == words.end() ? reason : found->second;
}

void
PrintRemarks(const ReconstructionReport & report, std::ostream & stream)
{
  std::map<std::string, std::vector<Label>> labels;
  for (const Note & note : CollectNotes(report))
  {
    labels[note.reason].push_back(note.label);
  }
  if (!labels.empty())
  {
    stream << "Cells with remarks (all of them, by label, in --report):\n";
  }
  for (const auto & [reason, some] : labels)
  {
    stream << std::setw(7) << some.size() << ' ' << DescribeReason(reason) << ": " << NameLabels(some) << '\n';
  }
}
} // namespace

void
Print(const ReconstructionReport & report, std::ostream & stream)
{
  const TissueInput & input = report.input;
  const WallMesh &    mesh = report.reconstruction.walls;
  const auto &        junctions = input.junctions->GetJunctionSet();
  const std::size_t   numberOfCells = junctions.cells.size() - 1;
  stream << report.options.MainInput() << ": ";
  if (input.numberOfPoints > 0)
  {
    stream << input.numberOfPoints << " points; ";
  }
  if (HasVoxels(report))
  {
    stream << input.size[0] << " x " << input.size[1] << " x " << input.size[2] << " voxels of " << input.spacing[0]
           << " x " << input.spacing[1] << " x " << input.spacing[2] << ", ";
  }
  stream << numberOfCells << " cells, exterior label " << input.exteriorLabel << '\n';
  if (report.options.closeGaps)
  {
    stream << "Gaps up to a width of " << input.closedGapWidth << " closed: " << input.numberOfClosedVoxels
           << " voxels given to cells, at most " << input.largestClosedDistance << " away\n";
  }
  PrintStages(report.reconstruction, HasLabelImage(report), stream);
  if (report.judge != nullptr)
  {
    PrintEvaluation(report, stream);
  }
  stream << "Mesh: " << mesh.walls.size() << " walls, " << mesh.points.size() << " points, " << mesh.triangles.size()
         << " triangles, " << std::setprecision(1)
         << static_cast<double>(mesh.triangles.size()) / static_cast<double>(numberOfCells) << " a cell\n";
  if (report.reconstruction.numberOfParts > 1)
  {
    stream << "Parts of the tissue that share no junction: " << report.reconstruction.numberOfParts << '\n';
  }
  if (report.reconstruction.numberOfVoids > 0)
  {
    stream << "Voids enclosed in the tissue: " << report.reconstruction.numberOfVoids << '\n';
  }
  stream << "Cells that are closed spheres: "
         << numberOfCells - report.check.cellsThatAreNoSphere.size() - report.check.cellsWithoutTriangles.size()
         << " of " << numberOfCells << "; points with more than four cells: " << report.check.crowdedPoints.size()
         << '\n';
  PrintRemarks(report, stream);
  const char * separator = "Written: ";
  for (const auto & [path, content] : report.options.Outputs())
  {
    stream << separator << path << " (" << content << ')';
    separator = ", ";
  }
  stream << '\n';
}
} // namespace tissue
