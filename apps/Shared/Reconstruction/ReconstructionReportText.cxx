/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ReconstructionReport.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <tuple>

namespace tissue
{
namespace
{
void
PrintEvaluation(const StageEvaluation & evaluation, const std::vector<ReconstructionStage> & stages,
                std::ostream & stream)
{
  stream << "Agreement with " << evaluation.against << ", adjacency2 / adjacency4 / of neighbours alone: " << std::fixed
         << std::setprecision(4);
  for (std::size_t i = 0; i < stages.size(); ++i)
  {
    const AdjacencyOverlap & overlap = evaluation.stages[i];
    stream << (i > 0 ? ", " : "") << stages[i].name << ' ' << overlap.adjacency2 << " / " << overlap.adjacency4 << " / "
           << overlap.adjacency4OfNeighbors;
  }
  stream << '\n';
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
  for (const ReconstructionStage & stage : r.stages)
  {
    const ComplexStatistics & s = stage.statistics;
    stream << std::left << std::setw(11) << stage.name << std::right;
    if (hasLabelImage)
    {
      stream << std::setprecision(4) << std::setw(11) << s.overlap.adjacency2 << std::setw(11) << s.overlap.adjacency4;
    }
    stream << std::setprecision(3) << std::setw(15) << s.neighborhoodError << std::setw(14) << s.eccentricity
           << std::setprecision(1) << std::setw(12) << s.minimalDihedralAngle << std::setw(12) << s.maximalDihedralAngle
           << std::setprecision(3) << std::setw(10) << stage.seconds << '\n';
  }
}

void
PrintRemarks(const ReconstructionReport & report, std::ostream & stream)
{
  // By their words, so that the order is that of the alphabet.
  std::map<std::string, std::vector<CellRemark>> remarksOfWord;
  for (const CellRemark & remark : CollectAllRemarks(report))
  {
    remarksOfWord[ToString(remark.remark)].push_back(remark);
  }
  if (!remarksOfWord.empty())
  {
    stream << "Cells with remarks (all of them, by label, in --report):\n";
  }
  for (const auto & [word, remarks] : remarksOfWord)
  {
    std::vector<VertexId> cells;
    for (const CellRemark & remark : remarks)
    {
      cells.push_back(remark.cell);
    }
    stream << std::setw(7) << cells.size() << ' ' << DescribeSeveral(remarks.front().remark) << ": "
           << NameLabels(LabelsOf(cells, report.GetCells())) << '\n';
  }
}

/** The labels of the image that are exterior, dropped ones apart. */
std::string
DescribeExterior(const ReconstructionReport & report)
{
  const TissueInput &        input = report.input;
  const std::vector<Label> & dropped = input.extracted.droppedLabels;
  std::vector<Label>         others;
  for (const Label label : input.GetJunctionSet().exteriorLabels)
  {
    if (label != input.extracted.exteriorLabel && label != 0 &&
        !std::binary_search(dropped.begin(), dropped.end(), label))
    {
      others.push_back(label);
    }
  }
  return "label " + std::to_string(input.extracted.exteriorLabel) + (others.empty() ? "" : ", " + NameLabels(others)) +
         (dropped.empty() ? "" : "; dropped as no cells: " + NameLabels(dropped));
}

void
PrintInput(const ReconstructionReport & report, std::ostream & stream)
{
  const TissueInput & input = report.input;
  stream << input.file << ": ";
  if (input.numberOfPoints > 0)
  {
    stream << input.numberOfPoints << " points" << (input.pointUnit.empty() ? "" : " in " + input.pointUnit) << "; ";
  }
  if (report.HasVoxels())
  {
    const auto & [size, spacing] = std::tie(input.image.size, input.image.spacing);
    stream << size[0] << " x " << size[1] << " x " << size[2] << " voxels of " << spacing[0] << " x " << spacing[1]
           << " x " << spacing[2] << (input.image.unit.empty() ? "" : " " + input.image.unit) << ", ";
  }
  stream << report.GetCells().size() - 1 << " cells, exterior " << DescribeExterior(report) << '\n';
  if (report.NumberOfVoids() > 0)
  {
    stream << "Voids enclosed in the tissue: " << report.NumberOfVoids() << '\n';
  }
  if (input.membraneMinima)
  {
    stream << "Membranes: noise of deviation " << input.membraneMinima->noise << ", minima at least "
           << input.membraneMinima->depth << " of the range deep are cells\n";
  }
  if (input.closedGaps)
  {
    stream << "Gaps up to a width of " << input.closedGaps->width << " closed: " << input.closedGaps->numberOfVoxels
           << " voxels given to cells, at most " << input.closedGaps->largestDistance << " away\n";
  }
}

void
PrintMesh(const ReconstructionReport & report, std::ostream & stream)
{
  const TissueReconstruction & reconstruction = report.GetReconstruction();
  const WallMesh &             mesh = reconstruction.walls;
  const CellSurfaceCheck &     check = report.tissue.check;
  const std::size_t            numberOfCells = report.GetCells().size() - 1;
  stream << "Mesh: " << mesh.walls.size() << " walls, " << mesh.points.size() << " points, " << mesh.triangles.size()
         << " triangles, " << std::setprecision(1)
         << static_cast<double>(mesh.triangles.size()) / static_cast<double>(numberOfCells) << " a cell\n";
  stream << "Points with more than four cells: " << check.crowdedPoints.size() << '\n';
}

/** How good the mesh is, in the last lines, in few words. */
void
PrintVerdict(const ReconstructionReport & report, std::ostream & stream)
{
  const TissueReconstruction & reconstruction = report.GetReconstruction();
  const CellSurfaceCheck &     check = report.tissue.check;
  const std::vector<Cell> &    cells = report.GetCells();
  const std::size_t            numberOfCells = cells.size() - 1;
  stream << "Closed spheres: " << numberOfCells - check.cellsThatAreNoSphere.size() - check.cellsWithoutTriangles.size()
         << " of " << numberOfCells << " cells; pairs of triangles that cross: " << reconstruction.fitting.crossingPairs
         << '\n';
  if (const auto volumes = MeasureVolumeErrors(report))
  {
    const AdjacencyOverlap & overlap = reconstruction.stages.back().statistics.overlap;
    stream << std::fixed << "Volumes: mean error " << std::setprecision(2) << 100.0 * volumes->mean
           << " %, cells above 1 %: " << volumes->numberAboveOnePercent << "; adjacency2 " << std::setprecision(4)
           << overlap.adjacency2 << ", adjacency4 " << overlap.adjacency4 << std::defaultfloat << '\n';
  }
  const auto worst = FindWorstRemark(report);
  stream << "Worst remark: "
         << (worst ? "cell " + std::to_string(cells[worst->cell].label) + ' ' + Describe(*worst) : "none") << '\n';
}
} // namespace

void
Print(const ReconstructionReport & report, const OutputPaths & outputs, std::ostream & stream)
{
  PrintInput(report, stream);
  PrintStages(report.GetReconstruction(), report.HasLabelImage(), stream);
  if (report.evaluation)
  {
    PrintEvaluation(*report.evaluation, report.GetReconstruction().stages, stream);
  }
  PrintMesh(report, stream);
  PrintRemarks(report, stream);
  const char * separator = "Written: ";
  for (const auto & [path, content] : outputs.List())
  {
    stream << separator << path << " (" << content << ')';
    separator = ", ";
  }
  stream << '\n';
  PrintVerdict(report, stream);
}

void
Say(const ReconstructionReport & report, const OutputPaths & outputs, bool isQuiet)
{
  for (const std::string & warning : CollectWarnings(report))
  {
    std::cerr << report.program << ": warning: " << warning << '\n';
  }
  if (!isQuiet)
  {
    Print(report, outputs, std::cout);
  }
}
} // namespace tissue
