/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ReconstructionReport.h"

#include "Shared/Reconstruction/SuspectLabels.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Geometry/TriangleQuality.h"

#include <itkMultiThreaderBase.h>

#include <cmath>
#include <map>

namespace tissue
{
namespace
{
using Json = nlohmann::ordered_json;

/** Null where it is not known. */
template <typename T>
Json
ToJsonIf(bool isKnown, const T & value)
{
  return isKnown ? Json(value) : Json();
}

Json
ToJson(const AdjacencyOverlap & overlap)
{
  return { { "adjacency2", overlap.adjacency2 },
           { "adjacency4", overlap.adjacency4 },
           { "adjacency4OfNeighbors", overlap.adjacency4OfNeighbors },
           { "falsePairs", overlap.numberOfFalsePairs },
           { "missingPairs", overlap.numberOfMissingPairs } };
}

Json
ToJson(const ReconstructionStage & stage, bool hasLabelImage)
{
  const ComplexStatistics & s = stage.statistics;
  Json                      json = ToJson(s.overlap);
  for (auto & value : json)
  {
    value = ToJsonIf(hasLabelImage, value);
  }
  json.update({ { "neighborhoodError", s.neighborhoodError },
                { "eccentricity", s.eccentricity },
                { "minimalDihedralAngle", s.minimalDihedralAngle },
                { "maximalDihedralAngle", s.maximalDihedralAngle },
                { "tetrahedra", s.numberOfTetrahedra },
                { "edges", s.numberOfEdges },
                { "innerTetrahedra", s.numberOfInnerTetrahedra },
                { "invertedTetrahedra", s.numberOfInvertedTetrahedra },
                { "epidermalCells", s.numberOfEpidermalCells } });
  return json;
}

/** The labels of the cell that has the angle and of its wall's cells, and the mean of the place's points. */
Json
SharpPlacesToJson(const TissueReconstruction & reconstruction, const std::vector<Cell> & cells)
{
  constexpr const char * kinds[] = { "triangleAngle", "dihedralAngle", "edgeLength" };
  Json                   places = Json::array();
  for (const SharpPlace & place : reconstruction.fitting.sharpPlaces)
  {
    const auto & points = reconstruction.walls.points;
    const int    count = place.points[2] >= 0 ? 3 : 2;
    Point        mean{ { 0.0, 0.0, 0.0 } };
    for (int i = 0; i < count; ++i)
    {
      mean = mean + (1.0 / count) * points[place.points[i]];
    }
    const VertexPair & wall = reconstruction.walls.walls[place.wall].cells;
    places.push_back({ { "kind", kinds[static_cast<int>(place.kind)] },
                       { "value", place.value },
                       { "label", cells[place.cell].label },
                       { "wall", { cells[wall[0]].label, cells[wall[1]].label } },
                       { "position", { mean[0], mean[1], mean[2] } } });
  }
  return places;
}

/** The numbers of cells of each layer, from the epidermis on; cells of no layer are in none. */
Json
LayersToJson(const std::vector<CellStatistics> & cells)
{
  std::map<std::int32_t, std::size_t> counts;
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    ++counts[cells[v].layer];
  }
  Json json = Json::array();
  for (const auto & entry : counts)
  {
    if (entry.first > 0)
    {
      json.push_back(entry.second);
    }
  }
  return json;
}

/** Areas of the tissue's surface, voids included, and of where the tissue is cut. */
Json
SurfaceToJson(const std::vector<CellStatistics> & cells)
{
  double exteriorArea = 0.0;
  double cutArea = 0.0;
  for (const CellStatistics & cell : cells)
  {
    exteriorArea += cell.exteriorArea;
    cutArea += cell.cutArea;
  }
  return { { "exteriorArea", exteriorArea }, { "cutArea", cutArea }, { "cellsOfLayers", LayersToJson(cells) } };
}

Json
MeshToJson(const ReconstructionReport & report)
{
  const TissueReconstruction & reconstruction = report.GetReconstruction();
  const WallMesh &             mesh = reconstruction.walls;
  const CellSurfaceCheck &     check = report.tissue.check;
  const std::vector<Cell> &    cells = report.GetCells();
  const auto                   volumes = MeasureVolumeErrors(report);
  const QualitySummary         quality = SummarizeTriangleQuality(mesh.points, mesh.triangles);
  return { { "points", mesh.points.size() },
           { "triangles", mesh.triangles.size() },
           { "walls", mesh.walls.size() },
           { "fitted", reconstruction.isFitted },
           { "cornersNotFitted", reconstruction.fitting.unfittedCorners },
           { "untangledPairs", reconstruction.fitting.untangledPairs },
           { "crossingPairs", reconstruction.fitting.crossingPairs },
           { "isEmbedded", reconstruction.fitting.isEmbedded },
           { "starWalls", reconstruction.fitting.starWalls },
           { "meanVolumeError", volumes ? Json(volumes->mean) : Json() },
           { "cellsAboveOnePercent", volumes ? Json(volumes->numberAboveOnePercent) : Json() },
           { "triangleQuality",
             { { "mean", quality.mean }, { "fifthPercentile", quality.fifthPercentile }, { "least", quality.least } } },
           { "minimumTriangleAngle", check.angles.minimumTriangleAngle },
           { "minimumDihedralAngle", check.angles.minimumDihedralAngle },
           { "edgeLengthRatio", check.angles.EdgeLengthRatio() },
           { "sharpPlaces", SharpPlacesToJson(reconstruction, cells) },
           { "surface", SurfaceToJson(report.tissue.statistics.cells) },
           { "trianglesPerCell", static_cast<double>(mesh.triangles.size()) / static_cast<double>(cells.size() - 1) },
           { "pointsWithMoreThanFourCells", check.crowdedPoints.size() },
           { "degenerateTriangles", check.numberOfDegenerateTriangles },
           { "cellsWithoutTriangles", LabelsOf(check.cellsWithoutTriangles, cells) },
           { "cellsThatAreNoClosedSphere", LabelsOf(check.cellsThatAreNoSphere, cells) } };
}

Json
ToJson(const StageEvaluation & evaluation, const std::vector<ReconstructionStage> & stages)
{
  Json json{ { "against", evaluation.against },
             { "cellsWithoutCounterpart", evaluation.numberOfUnknownCells },
             { "missedCells", evaluation.numberOfMissedCells } };
  for (std::size_t i = 0; i < stages.size(); ++i)
  {
    json[stages[i].name] = ToJson(evaluation.stages[i]);
  }
  return json;
}

/** Of each label; null where there are none. */
Json
NamesToJson(const std::map<Label, std::string> & names)
{
  Json json;
  for (const auto & [label, name] : names)
  {
    json[std::to_string(label)] = name;
  }
  return json;
}

Json
InputToJson(const ReconstructionReport & report)
{
  const TissueInput & input = report.input;
  const JunctionSet & junctions = input.GetJunctionSet();
  const bool          hasLabelImage = report.HasLabelImage();
  const bool          hasVoxels = report.HasVoxels();
  const ClosedGaps    gaps = input.closedGaps.value_or(ClosedGaps());
  Json                minima;
  if (input.membraneMinima)
  {
    minima = { { "noise", input.membraneMinima->noise }, { "leastDepth", input.membraneMinima->depth } };
  }
  return { { "file", input.file },
           { "points", input.numberOfPoints },
           { "pointUnit", ToJsonIf(!input.pointUnit.empty(), input.pointUnit) },
           { "names", NamesToJson(input.names) },
           { "pixelType", ToJsonIf(!input.image.pixelType.empty(), input.image.pixelType) },
           { "size", ToJsonIf(hasVoxels, input.image.size) },
           { "spacing", ToJsonIf(hasVoxels, input.image.spacing) },
           { "unit", ToJsonIf(!input.image.unit.empty(), input.image.unit) },
           { "exteriorLabel", input.extracted.exteriorLabel },
           { "exteriorLabels", junctions.exteriorLabels },
           { "droppedLabels", input.extracted.droppedLabels },
           { "suspects", FindSuspectLabels(junctions) },
           { "cells", junctions.cells.size() - 1 },
           { "voids", ToJsonIf(hasLabelImage, report.NumberOfVoids()) },
           { "walls", ToJsonIf(hasLabelImage, junctions.walls.size()) },
           { "tripleLines", ToJsonIf(hasLabelImage, junctions.tripleLines.size()) },
           { "junctions", ToJsonIf(hasLabelImage, junctions.junctions.size()) },
           { "blocksOfMoreThanFourCells", ToJsonIf(hasLabelImage, junctions.numberOfCrowdedBlocks) },
           { "closedGaps",
             { { "width", gaps.width },
               { "voxels", gaps.numberOfVoxels },
               { "largestDistance", gaps.largestDistance },
               { "shareLeft", gaps.shareLeft } } },
           { "membraneMinima", minima } };
}

Json
CyclesToJson(const std::vector<AnnealingCycle> & cycles)
{
  Json json = Json::array();
  for (const AnnealingCycle & cycle : cycles)
  {
    json.push_back({ { "temperature", cycle.temperature },
                     { "edgeRemovals", cycle.numberOfRemovals },
                     { "triangleSwaps", cycle.numberOfSwaps },
                     { "energy", cycle.energy } });
  }
  return json;
}

Json
RemarksToJson(const ReconstructionReport & report)
{
  Json json = Json::array();
  for (const CellRemark & remark : CollectAllRemarks(report))
  {
    json.push_back({ { "label", report.GetCells()[remark.cell].label },
                     { "reason", ToString(remark.remark) },
                     { "value", remark.value },
                     { "text", Describe(remark) } });
  }
  return json;
}

Json
SecondsToJson(const ReconstructionReport & report)
{
  const TissueReconstruction & r = report.GetReconstruction();
  // With the threads that the times are for: nothing else in the report depends on them.
  Json json{
    { "threads", itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads() },
    { "read", report.input.seconds.read },
    { "closeGaps", report.input.seconds.closeGaps },
    { "segmentation", report.input.seconds.segment },
    { "extractJunctions", report.input.extracted.seconds },
  };
  for (const ReconstructionStage & stage : r.stages)
  {
    json[stage.name] = stage.seconds;
  }
  json["dual"] = r.dualSeconds;
  json["check"] = report.tissue.checkSeconds;
  return json;
}
} // namespace

Json
ToJson(const ReconstructionReport & report)
{
  const TissueReconstruction & r = report.GetReconstruction();
  const bool                   hasLabelImage = report.HasLabelImage();
  Json                         json;
  json["program"] = { { "name", report.program }, { "version", TISSUE_TESSELLATION_VERSION } };
  json["input"] = InputToJson(report);
  json["options"] = report.options;
  for (const ReconstructionStage & stage : r.stages)
  {
    json["stages"][stage.name] = ToJson(stage, hasLabelImage);
  }
  if (report.evaluation)
  {
    json["evaluation"] = ToJson(*report.evaluation, r.stages);
  }
  json["cleanUp"] = { { "maximumEdgeLength", r.maximumEdgeLength },
                      { "triangleSwaps", r.cleanUp.numberOfSwaps },
                      { "edgeRemovals", r.cleanUp.numberOfRemovals } };
  json["cycles"] = CyclesToJson(r.cycles);
  json["energy"] = r.energy;
  json["mesh"] = MeshToJson(report);
  json.update(report.projection.GetReport());
  json["faults"] = CollectFaults(report);
  json["warnings"] = CollectWarnings(report);
  json["remarks"] = RemarksToJson(report);
  json["seconds"] = SecondsToJson(report);
  return json;
}

std::vector<std::string>
CollectWarnings(const ReconstructionReport & report)
{
  std::vector<std::string> warnings = report.input.warnings;
  if (report.evaluation)
  {
    Append(report.evaluation->warnings, warnings);
  }
  Append(report.projection.GetWarnings(), warnings);
  Append(CollectFaults(report), warnings);
  return warnings;
}

std::vector<CellRemark>
CollectAllRemarks(const ReconstructionReport & report)
{
  std::vector<CellRemark>         remarks = CollectRemarks(report.tissue.check);
  const std::vector<CellRemark> & ofReconstruction = report.GetReconstruction().remarks;
  remarks.insert(remarks.end(), ofReconstruction.begin(), ofReconstruction.end());
  return remarks;
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
} // namespace tissue
