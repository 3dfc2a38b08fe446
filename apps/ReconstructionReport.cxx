/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "ReconstructionReport.h"

#include <nlohmann/json.hpp>

#include <iomanip>
#include <map>

namespace tissue
{
namespace
{
using Json = nlohmann::ordered_json;

Json
ToJson(const ReconstructionStage & stage)
{
  const ComplexStatistics & s = stage.statistics;
  return { { "adjacency2", s.adjacency2 },
           { "adjacency4", s.adjacency4 },
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

Json
MeshToJson(const ReconstructionReport & report)
{
  const WallMesh &          mesh = report.reconstruction.walls;
  const CellSurfaceCheck &  check = report.check;
  const std::vector<Cell> & cells = report.input.junctions->GetJunctionSet().cells;
  return { { "points", mesh.points.size() },
           { "triangles", mesh.triangles.size() },
           { "walls", mesh.walls.size() },
           { "trianglesPerCell", static_cast<double>(mesh.triangles.size()) / static_cast<double>(cells.size() - 1) },
           { "pointsWithMoreThanFourCells", check.crowdedPoints.size() },
           { "degenerateTriangles", check.numberOfDegenerateTriangles },
           { "cellsWithoutTriangles", LabelsOf(check.cellsWithoutTriangles, cells) },
           { "cellsThatAreNoClosedSphere", LabelsOf(check.cellsThatAreNoSphere, cells) } };
}

Json
SecondsToJson(const ReconstructionReport & report)
{
  const TissueReconstruction & r = report.reconstruction;
  return { { "read", report.input.readSeconds },
           { "closeGaps", report.input.closeGapsSeconds },
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
  Json                         json;
  json["program"] = { { "name", "TissueTessellation" }, { "version", TISSUE_TESSELLATION_VERSION } };
  json["input"] = { { "file", report.options.labels },
                    { "pixelType", report.input.pixelType },
                    { "size", report.input.size },
                    { "spacing", report.input.spacing },
                    { "exteriorLabel", report.input.exteriorLabel },
                    { "cells", junctions.cells.size() - 1 },
                    { "walls", junctions.walls.size() },
                    { "tripleLines", junctions.tripleLines.size() },
                    { "junctions", junctions.junctions.size() },
                    { "blocksOfMoreThanFourCells", junctions.numberOfCrowdedBlocks },
                    { "voxelsOfClosedGaps", report.input.numberOfClosedVoxels },
                    { "largestClosedDistance", report.input.largestClosedDistance } };
  json["options"] = ToJson(report.options);
  json["stages"] = { { "delaunay", ToJson(r.delaunay) },
                     { "cleaned", ToJson(r.cleaned) },
                     { "optimized", ToJson(r.optimized) } };
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
  json["mesh"] = MeshToJson(report);
  json["seconds"] = SecondsToJson(report);
  json["warnings"] = report.input.warnings;
  json["cells"] = Json::array();
  for (const CellRemark & remark : r.remarks)
  {
    json["cells"].push_back({ { "label", junctions.cells[remark.cell].label },
                              { "reason", ToString(remark.remark) },
                              { "value", remark.value },
                              { "text", Describe(remark) } });
  }
  return json;
}

namespace
{
void
PrintStages(const TissueReconstruction & r, std::ostream & stream)
{
  stream << "            adjacency2 adjacency4  neighbourhood  eccentricity  min. angle  max. angle   seconds\n"
         << std::fixed;
  const auto row = [&stream](const char * name, const ReconstructionStage & stage) {
    const ComplexStatistics & s = stage.statistics;
    stream << std::left << std::setw(12) << name << std::right << std::setprecision(4) << std::setw(10) << s.adjacency2
           << std::setw(11) << s.adjacency4 << std::setprecision(3) << std::setw(15) << s.neighborhoodError
           << std::setw(14) << s.eccentricity << std::setprecision(1) << std::setw(12) << s.minimalDihedralAngle
           << std::setw(12) << s.maximalDihedralAngle << std::setprecision(3) << std::setw(10) << stage.seconds << '\n';
  };
  row("Delaunay", r.delaunay);
  row("cleaned", r.cleaned);
  row("optimized", r.optimized);
}

void
PrintRemarks(const ReconstructionReport & report, std::ostream & stream)
{
  std::map<Remark, std::size_t> counts;
  for (const CellRemark & remark : report.reconstruction.remarks)
  {
    ++counts[remark.remark];
  }
  if (!counts.empty())
  {
    stream << "Cells with remarks (each by label in --report):\n";
  }
  for (const auto & [remark, count] : counts)
  {
    stream << "  " << std::left << std::setw(16) << ToString(remark) << std::right << std::setw(6) << count << '\n';
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
  stream << report.options.labels << ": " << input.size[0] << " x " << input.size[1] << " x " << input.size[2]
         << " voxels of " << input.spacing[0] << " x " << input.spacing[1] << " x " << input.spacing[2] << ", "
         << numberOfCells << " cells, exterior label " << input.exteriorLabel << '\n';
  if (input.numberOfClosedVoxels > 0)
  {
    stream << "Gaps closed: " << input.numberOfClosedVoxels << " voxels, at most " << input.largestClosedDistance
           << " from the label they were given\n";
  }
  PrintStages(report.reconstruction, stream);
  stream << "Mesh: " << mesh.walls.size() << " walls, " << mesh.points.size() << " points, " << mesh.triangles.size()
         << " triangles, " << std::setprecision(1)
         << static_cast<double>(mesh.triangles.size()) / static_cast<double>(numberOfCells) << " a cell\n"
         << "Cells that are closed spheres: "
         << numberOfCells - report.check.cellsThatAreNoSphere.size() - report.check.cellsWithoutTriangles.size()
         << " of " << numberOfCells << "; points with more than four cells: " << report.check.crowdedPoints.size()
         << '\n';
  PrintRemarks(report, stream);
}
} // namespace tissue
