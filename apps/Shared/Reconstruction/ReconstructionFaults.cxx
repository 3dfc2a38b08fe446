/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Reconstruction/ReconstructionReport.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace tissue
{
namespace
{
/** The remarks from the gravest on; those that are not here are no faults of the mesh. */
constexpr Remark ByGravity[] = {
  Remark::Missing,      Remark::NoClosedSphere,   Remark::VolumeOff,    Remark::VolumeNotFitted, Remark::VoxelWalls,
  Remark::ExteriorLost, Remark::WallsLost,        Remark::SuspectLarge, Remark::SuspectPocket,   Remark::SuspectPieces,
  Remark::HandlesKept,  Remark::FragmentDropped,  Remark::Sharp,        Remark::WallsGained,     Remark::ExteriorGained,
  Remark::Repaired,     Remark::CornersNotFitted, Remark::HandlesCut,   Remark::SeveralPieces
};

double
Badness(const CellRemark & remark)
{
  const bool isRatio = remark.remark == Remark::VolumeOff || remark.remark == Remark::VolumeNotFitted;
  return isRatio ? std::abs(remark.value - 1.0) : remark.value;
}

std::string
DescribeVolumes(const VolumeErrors & errors, const std::vector<Cell> & cells)
{
  std::ostringstream text;
  text << errors.aboveFivePercent.size() << " of " << cells.size() - 1
       << " cells are more than 5 % off their volume in the image, the mean error is " << std::setprecision(3)
       << 100.0 * errors.mean << " % (labels " << NameLabels(LabelsOf(errors.aboveFivePercent, cells)) << ')';
  return text.str();
}
} // namespace

std::optional<VolumeErrors>
MeasureVolumeErrors(const ReconstructionReport & report)
{
  if (!report.HasLabelImage())
  {
    return std::nullopt;
  }
  const std::vector<Cell> & cells = report.GetCells();
  VolumeErrors              errors;
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    const double error = std::abs(report.tissue.check.cells[v].volume / cells[v].volume - 1.0);
    errors.mean += error / static_cast<double>(cells.size() - 1);
    errors.numberAboveOnePercent += error > 0.01 ? 1 : 0;
    if (error > 0.05)
    {
      errors.aboveFivePercent.push_back(static_cast<VertexId>(v));
    }
  }
  return errors;
}

std::vector<std::string>
CollectFaults(const ReconstructionReport & report)
{
  const CellSurfaceCheck &  check = report.tissue.check;
  const std::vector<Cell> & cells = report.GetCells();
  std::vector<std::string>  faults;
  const auto                addCells = [&](const std::vector<VertexId> & vertices, const std::string & what) {
    if (!vertices.empty())
    {
      faults.push_back(std::to_string(vertices.size()) + (vertices.size() == 1 ? " cell " : " cells ") + what +
                       " (labels " + NameLabels(LabelsOf(vertices, cells)) + ")");
    }
  };
  addCells(check.cellsWithoutTriangles, "of the image are missing from the mesh");
  addCells(check.cellsThatAreNoSphere, "have a surface that is no closed sphere");
  if (!check.crowdedPoints.empty())
  {
    faults.push_back("at " + std::to_string(check.crowdedPoints.size()) +
                     " points of the mesh more than four cells meet");
  }
  const std::int64_t crossingPairs = report.GetReconstruction().fitting.crossingPairs;
  if (crossingPairs > 0)
  {
    faults.push_back(std::to_string(crossingPairs) + " pairs of triangles of the mesh cross");
  }
  if (report.GetReconstruction().fitting.isEmbedded)
  {
    std::vector<VertexId> notFitted = report.GetReconstruction().fitting.cellsNotFitted;
    notFitted.erase(std::unique(notFitted.begin(), notFitted.end()), notFitted.end());
    addCells(notFitted, "could not be fitted to the image, so that all walls are those of its voxels, and rough");
  }
  const auto volumes = MeasureVolumeErrors(report);
  if (volumes && !volumes->aboveFivePercent.empty())
  {
    faults.push_back(DescribeVolumes(*volumes, cells));
  }
  return faults;
}

std::optional<CellRemark>
FindWorstRemark(const ReconstructionReport & report)
{
  const std::vector<CellRemark> remarks = CollectAllRemarks(report);
  for (const Remark kind : ByGravity)
  {
    std::optional<CellRemark> worst;
    for (const CellRemark & remark : remarks)
    {
      if (remark.remark == kind && (!worst || Badness(remark) > Badness(*worst)))
      {
        worst = remark;
      }
    }
    if (worst)
    {
      return worst;
    }
  }
  return std::nullopt;
}

void
RequireNoFaults(const ReconstructionReport & report, bool isStrict)
{
  const std::vector<std::string> faults = CollectFaults(report);
  if (isStrict && !faults.empty())
  {
    throw StrictError("--strict: the mesh is written, but has faults: " + faults.front() +
                      (faults.size() > 1 ? ", and " + std::to_string(faults.size() - 1) + " more" : ""));
  }
}
} // namespace tissue
