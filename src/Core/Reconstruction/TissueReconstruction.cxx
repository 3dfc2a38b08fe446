/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

#include "Fitting/WallFitting.h"
#include "Geometry/SpatialOrder.h"
#include "Mesh/Cavities.h"
#include "Mesh/Crossings.h"
#include "Reconstruction/TissueComplex.h"
#include "Remeshing/WallRefinement.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace tissue
{
namespace
{
/** The complex's share of the whole, for the progress. */
constexpr double ComplexShare = 0.2;

/** Cell centres, with those that repeat an earlier one moved aside along the axes in turn. */
std::vector<Point>
SeparateCenters(const JunctionSet & junctions, std::vector<CellRemark> & remarks)
{
  std::vector<Point> centers;
  centers.reserve(static_cast<std::size_t>(junctions.NumberOfVertices()));
  std::set<Point> taken;
  const double    typical = MedianNeighborDistance(junctions);
  const double    step = 1e-3 * (typical > 0.0 ? typical : 1.0);
  for (VertexId v = ExteriorVertex; v < junctions.NumberOfVertices(); ++v)
  {
    const Cell & cell = junctions.cells[v];
    Point        center = cell.center;
    if (!centers.empty())
    {
      for (int i = 0; !taken.insert(center).second; ++i)
      {
        center = cell.center;
        center[i % 3] += step * (i / 3 + 1);
      }
      if (center != cell.center)
      {
        remarks.push_back({ v, Remark::CenterMoved, Distance(center, cell.center) });
      }
    }
    centers.push_back(center);
  }
  return centers;
}

/** The dual as stars, split and smoothed: the walls without an image. */
WallMesh
MakeStarWalls(const DualMesh & dual, const ReconstructionParameters & parameters)
{
  WallMesh walls = TriangulateAsStars(dual);
  for (int level = 0; level < parameters.refinement; ++level)
  {
    SplitTriangles(walls);
  }
  SmoothWalls(walls, parameters.smoothingIterations);
  return walls;
}

WallMesh
MakeFittedWalls(TissueComplex complex, const TissueCells & cells, const LabelVolume & volume,
                const ReconstructionParameters & parameters, WallFittingStatistics & statistics,
                const Execution & execution)
{
  std::vector<double> volumes;
  for (const Cell & cell : cells.junctions.cells)
  {
    volumes.push_back(cell.volume);
  }
  const LabelVolume & vertices = complex.volume.vertices.empty() ? volume : complex.volume;
  return FitWalls(std::move(complex.dual),
                  { volume, vertices, complex.cellOf, volumes, cells.ranks },
                  parameters.refinement > 0 ? parameters.trianglesPerCell : 0.0,
                  &statistics,
                  execution);
}

/** Names the cells whose volume is far from that in the image. */
void
RemarkVolumes(const WallMesh & walls, const JunctionSet & junctions, bool isFitted, std::vector<CellRemark> & remarks)
{
  constexpr double       most = 2.0;
  constexpr double       fitted = 0.01;
  const CellSurfaceCheck check = CheckCellSurfaces(walls, static_cast<VertexId>(junctions.cells.size()));
  for (std::size_t v = ExteriorVertex + 1; v < junctions.cells.size(); ++v)
  {
    const double ratio = check.cells[v].volume / junctions.cells[v].volume;
    if (!(ratio >= 1.0 / most && ratio <= most))
    {
      remarks.push_back({ static_cast<VertexId>(v), Remark::VolumeOff, ratio });
    }
    else if (isFitted && std::abs(ratio - 1.0) > fitted)
    {
      remarks.push_back({ static_cast<VertexId>(v), Remark::VolumeNotFitted, ratio });
    }
  }
}

/** Remarks how often each cell is in a list. */
void
RemarkCounts(const std::vector<VertexId> & cells, Remark reason, std::vector<CellRemark> & remarks)
{
  std::map<VertexId, int> counts;
  for (const VertexId cell : cells)
  {
    ++counts[cell];
  }
  for (const auto & [cell, count] : counts)
  {
    remarks.push_back({ cell, reason, static_cast<double>(count) });
  }
}

/** Names the cells with corners that are not at the image's. */
void
RemarkCorners(const std::vector<std::int32_t> & unfittedCornersOfCell, std::size_t numberOfCells,
              std::vector<CellRemark> & remarks)
{
  for (std::size_t v = ExteriorVertex + 1; v < std::min(numberOfCells, unfittedCornersOfCell.size()); ++v)
  {
    if (unfittedCornersOfCell[v] > 0)
    {
      remarks.push_back(
        { static_cast<VertexId>(v), Remark::CornersNotFitted, static_cast<double>(unfittedCornersOfCell[v]) });
    }
  }
}

/** The cells with holes of background, one for each hole. */
std::vector<VertexId>
CellsOfCavities(const WallMesh & walls)
{
  std::vector<VertexId> cells;
  for (const Cavity & cavity : FindCavities(walls))
  {
    cells.push_back(cavity.cell);
  }
  return cells;
}

/** The cells with places that are too sharp to compute on, one for each place. */
std::vector<VertexId>
CellsOfSharpPlaces(const TissueReconstruction & result)
{
  std::vector<VertexId> cells;
  for (const SharpPlace & place : result.fitting.sharpPlaces)
  {
    cells.push_back(place.cell != ExteriorVertex ? place.cell : result.walls.walls[place.wall].cells[0]);
  }
  return cells;
}

/** All remarks on the result, by cell; of each cell first those that follow from image and complex, then those of the
 * way to the complex, then those on the walls. */
std::vector<CellRemark>
GatherRemarks(const AdjacencyTuples & tuples, const JunctionSet & junctions, const TissueReconstruction & result)
{
  const bool              hasWalls = !junctions.walls.empty();
  std::vector<CellRemark> remarks = hasWalls ? CollectRemarks(tuples, junctions) : std::vector<CellRemark>();
  remarks.insert(remarks.end(), result.remarks.begin(), result.remarks.end());
  if (hasWalls)
  {
    RemarkVolumes(result.walls, junctions, result.isFitted, remarks);
  }
  RemarkCounts(CellsOfCavities(result.walls), Remark::Cavities, remarks);
  RemarkCounts(result.fitting.cellsOfFilledVoids, Remark::CavitiesFilled, remarks);
  RemarkCorners(result.fitting.unfittedCornersOfCell, junctions.cells.size(), remarks);
  RemarkCounts(CellsOfSharpPlaces(result), Remark::Sharp, remarks);
  std::stable_sort(
    remarks.begin(), remarks.end(), [](const CellRemark & a, const CellRemark & b) { return a.cell < b.cell; });
  return remarks;
}
} // namespace

ReconstructionStage
MakeStage(const std::string & name, double seconds, const std::vector<VertexQuadruple> & tetrahedra,
          const AdjacencyTuples & tuples, const TissueCells & cells, const ReconstructionParameters & parameters)
{
  ReconstructionStage stage;
  stage.name = name;
  stage.seconds = seconds;
  stage.statistics = ComputeStatistics(tetrahedra, tuples, cells.centers, &cells.reference, parameters.energy);
  if (parameters.keepStages)
  {
    stage.tuples = tuples;
  }
  return stage;
}

TissueReconstruction
ReconstructTissue(const JunctionSet & junctions, const ReconstructionParameters & parameters,
                  const LabelVolume * volume, const Execution & execution)
{
  parameters.Check();
  if (parameters.source == ComplexSource::Image && volume == nullptr)
  {
    throw std::invalid_argument("ReconstructTissue: a complex from the image needs the label volume");
  }
  TissueReconstruction        result;
  const std::vector<Point>    centers = SeparateCenters(junctions, result.remarks);
  const std::vector<VertexId> order = SpatialOrder(centers);
  const std::vector<VertexId> ranks = RanksInOrder(order);
  const ReferenceAdjacency    reference(junctions);
  const TissueCells           cells{ junctions, reference, centers, order, ranks };
  const Execution             first = execution.Part(0.0, ComplexShare);
  const bool                  isOfImage = parameters.source == ComplexSource::Image;
  execution.EnterPhase(isOfImage ? "Finding the complex" : "Optimizing the complex");
  TissueComplex complex = isOfImage ? TakeComplexFromImage(cells, *volume, parameters, result, first)
                                    : MakeComplexFromCenters(cells, parameters, result, first);

  Stopwatch             stopwatch;
  const AdjacencyTuples tuples = complex.tuples;
  result.isFitted = volume != nullptr && parameters.fitToImage;
  result.walls =
    result.isFitted
      ? MakeFittedWalls(
          std::move(complex), cells, *volume, parameters, result.fitting, execution.Part(ComplexShare, 1.0))
      : MakeStarWalls(complex.dual.mesh, parameters);
  if (!result.isFitted)
  {
    result.fitting.crossingPairs = static_cast<std::int64_t>(FindCrossings(result.walls, execution).size());
  }
  result.remarks = GatherRemarks(tuples, junctions, result);
  result.dualSeconds = stopwatch.Lap().wallSeconds;
  execution.Report(1.0);
  return result;
}
} // namespace tissue
