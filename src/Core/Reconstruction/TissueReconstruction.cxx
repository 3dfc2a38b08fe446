/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

#include "Adjacency/ReferenceAdjacency.h"
#include "Adjacency/SpatialNumbering.h"
#include "Adjacency/TissueParts.h"
#include "Complex/DelaunayTetrahedralization.h"
#include "Complex/LocalSpacing.h"
#include "Dual/CellCorners.h"
#include "Dual/DualMesh.h"
#include "Image/NumberedVolume.h"
#include "Optimization/TopologyOptimizer.h"
#include "Reconstruction/VertexRestoration.h"
#include "Reconstruction/VoidMerging.h"
#include "Remeshing/WallRefinement.h"
#include "TissueTessellationCore/Adjacency/Voids.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace tissue
{
namespace
{
/** Shares of the whole, for the progress. */
constexpr double DelaunayShare = 0.05;
constexpr double OptimizationShare = 0.15;

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
    const Cell & cell = junctions.CellOfVertex(v);
    Point        center = cell.center;
    if (!centers.empty())
    {
      for (int i = 0; !taken.insert(center).second; ++i)
      {
        center = cell.center;
        center[i % 3] += step * (i / 3 + 1);
      }
      if (center != cell.center && !junctions.IsVoid(v))
      {
        remarks.push_back({ v, Remark::CenterMoved, Distance(center, cell.center) });
      }
    }
    centers.push_back(center);
  }
  return centers;
}

/** What the pipeline works on, under spatial numbers: on large tissues much of the time would else go to fetching what
 * lies far apart. */
struct NumberedTissue
{
  /** The image's by its own vertices, with those voids merged that are not to be vertices. */
  JunctionSet image;
  /** Of these vertices; all that follows is under its numbers. */
  SpatialNumbering   numbering;
  JunctionSet        junctions;
  std::vector<Point> centers;
  /** The cells and voids of each part of the tissue. */
  std::vector<std::vector<VertexId>> parts;
  /** The number of each vertex of the label volume, which has all voids. */
  std::vector<VertexId> numbersOfVolume;
};

/** The door: decides on voids and parts, and numbers the vertices. */
NumberedTissue
NumberTissue(const JunctionSet & image, const ReconstructionParameters & parameters, std::vector<CellRemark> & remarks)
{
  NumberedTissue tissue;
  tissue.image = parameters.separateVoids ? image : MergeVoids(image);
  const std::vector<Point> centers = SeparateCenters(tissue.image, remarks);
  const TissueParts        parts =
    parameters.separateParts ? FindTissueParts(tissue.image, centers) : JoinTissueParts(tissue.image);
  for (const VertexId cell : parts.strayCells)
  {
    remarks.push_back({ cell, Remark::StrayPart, 0.0 });
  }
  if (parts.parts.size() > 1 && !tissue.image.voids.empty())
  {
    tissue.image = MergeVoidsOfOtherParts(tissue.image, parts.PartOfVertex(tissue.image.NumberOfVertices()));
  }

  tissue.numbering = NumberSpatially(tissue.image, centers);
  tissue.junctions = Renumbered(tissue.image, tissue.numbering);
  for (const VertexId v : tissue.numbering.order)
  {
    tissue.centers.push_back(centers[v]);
  }
  tissue.parts = parts.parts;
  for (std::vector<VertexId> & part : tissue.parts)
  {
    std::transform(part.begin(), part.end(), part.begin(), [&tissue](VertexId v) { return tissue.numbering.ranks[v]; });
    std::sort(part.begin(), part.end());
  }
  tissue.numbersOfVolume = tissue.numbering.ranks;
  tissue.numbersOfVolume.resize(static_cast<std::size_t>(image.NumberOfVertices()), ExteriorVertex);
  return tissue;
}

/** The exit for tetrahedra: by the image's vertices, the voids as the exterior. */
std::vector<VertexQuadruple>
TetrahedraOfImage(const AdjacencyComplex & complex, const NumberedTissue & tissue)
{
  return MergeVoids(RestoreVertices(complex.GetTetrahedra(), tissue.numbering.order), tissue.image);
}

/** The exit for the walls and what is known of the cells. */
void
RestoreWalls(const AdjacencyComplex & complex, const NumberedTissue & tissue, TissueReconstruction & result)
{
  RestoreVertices(result.walls, complex.GetTetrahedra(), tissue.numbering.order);
  MergeVoids(result.walls, tissue.image);
  std::vector<std::int32_t> & unfitted = result.fitting.unfittedCornersOfCell;
  const auto                  byNumber = unfitted;
  for (std::size_t i = 0; i < byNumber.size(); ++i)
  {
    unfitted[tissue.numbering.order[i]] = byNumber[i];
  }
}

/** The Delaunay tetrahedralization of each part of the tissue, closed by the exterior. */
std::vector<VertexQuadruple>
TetrahedralizeParts(const NumberedTissue & tissue)
{
  std::vector<VertexQuadruple> tetrahedra;
  for (const std::vector<VertexId> & part : tissue.parts)
  {
    std::vector<VertexId> vertices{ ExteriorVertex };
    vertices.insert(vertices.end(), part.begin(), part.end());
    std::vector<Point> points;
    for (const VertexId v : vertices)
    {
      points.push_back(tissue.centers[v]);
    }
    const auto ofPart = RestoreVertices(DelaunayTetrahedralization(points), vertices);
    tetrahedra.insert(tetrahedra.end(), ofPart.begin(), ofPart.end());
  }
  std::sort(tetrahedra.begin(), tetrahedra.end());
  return tetrahedra;
}

/** How the Delaunay complex is to be cleaned. */
SurfaceCleanUpParameters
MakeCleanUp(const NumberedTissue & tissue, const ReconstructionParameters & parameters,
            const AdjacencyComplex & complex)
{
  SurfaceCleanUpParameters cleanUp;
  cleanUp.guidedByReference = parameters.guidedCleanUp;
  cleanUp.maximumEdgeLength = parameters.maximumEdgeLength;
  if (!(parameters.maximumEdgeLength > 0.0))
  {
    const double median = parameters.localMaximumEdgeLength ? 0.0 : MedianNeighborDistance(tissue.junctions);
    cleanUp.maximumEdgeLength = parameters.maximumEdgeLengthFactor * (median > 0.0 ? median : 1.0);
    cleanUp.localLengths = median > 0.0 ? std::vector<double>() : LocalSpacings(complex, tissue.centers);
  }
  return cleanUp;
}

/** The complex through its stages, which `result` learns of. */
AdjacencyComplex
ReconstructComplex(const NumberedTissue & tissue, const ReconstructionParameters & parameters,
                   TissueReconstruction & result, const Execution & execution)
{
  Stopwatch                stopwatch;
  const ReferenceAdjacency reference(tissue.junctions);
  // The statistics of a stage do not count for the time of the next one.
  const auto finishStage = [&](const AdjacencyComplex & complex) {
    ReconstructionStage stage;
    stage.seconds = stopwatch.Lap().wallSeconds;
    stage.statistics = ComputeStatistics(complex, tissue.centers, &reference, parameters.energy);
    if (parameters.keepStages)
    {
      stage.tetrahedra = TetrahedraOfImage(complex, tissue);
    }
    stopwatch.Lap();
    return stage;
  };

  AdjacencyComplex complex(tissue.junctions.NumberOfVertices(), TetrahedralizeParts(tissue));
  result.delaunay = finishStage(complex);
  execution.Report(DelaunayShare);

  const SurfaceCleanUpParameters cleanUp = MakeCleanUp(tissue, parameters, complex);
  result.maximumEdgeLength =
    cleanUp.maximumEdgeLength * (cleanUp.localLengths.empty() ? 1.0 : MedianSpacing(cleanUp.localLengths));
  result.cleanUp = CleanSurface(complex, tissue.centers, &reference, cleanUp);
  result.cleaned = finishStage(complex);

  TopologyOptimizer optimizer(complex, tissue.centers, &reference, parameters.energy, parameters.annealing);
  result.cycles = optimizer.Run(execution.Part(DelaunayShare, DelaunayShare + OptimizationShare));
  result.numberOfRelocatedVertices = optimizer.NumberOfRelocatedVertices();
  result.energy = optimizer.Energy();
  result.optimized = finishStage(complex);
  return complex;
}

/** The dual of the complex as stars, split and smoothed: the walls without an image. */
WallMesh
MakeStarWalls(const AdjacencyComplex & complex, const JunctionSet & junctions,
              const ReconstructionParameters & parameters)
{
  WallMesh walls = TriangulateAsStars(Dualize(complex, ComputeCorners(complex, junctions, parameters.corners)));
  for (int level = 0; level < parameters.refinement; ++level)
  {
    SplitTriangles(walls);
  }
  SmoothWalls(walls, parameters.smoothingIterations);
  return walls;
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

/** All remarks on the result, by cell; of each cell first those that follow from image and complex, then those of the
 * `door`, then those on the walls. */
std::vector<CellRemark>
GatherRemarks(const AdjacencyComplex & complex, const NumberedTissue & tissue, const TissueReconstruction & result,
              const std::vector<CellRemark> & door)
{
  const bool              hasWalls = !tissue.image.walls.empty();
  std::vector<CellRemark> remarks = hasWalls ? CollectRemarks(complex, tissue.junctions) : std::vector<CellRemark>();
  for (CellRemark & remark : remarks)
  {
    remark.cell = tissue.numbering.order[remark.cell];
  }
  remarks.insert(remarks.end(), door.begin(), door.end());
  if (hasWalls)
  {
    RemarkVolumes(result.walls, tissue.image, result.isFitted, remarks);
  }
  RemarkCorners(result.fitting.unfittedCornersOfCell, tissue.image.cells.size(), remarks);
  std::stable_sort(
    remarks.begin(), remarks.end(), [](const CellRemark & a, const CellRemark & b) { return a.cell < b.cell; });
  return remarks;
}
} // namespace

TissueReconstruction
ReconstructTissue(const JunctionSet & image, const ReconstructionParameters & parameters, const LabelVolume * volume,
                  const Execution & execution)
{
  parameters.Check();
  TissueReconstruction    result;
  std::vector<CellRemark> remarks;
  const NumberedTissue    tissue = NumberTissue(image, parameters, remarks);
  result.numberOfVoids = tissue.image.voids.size();
  result.numberOfParts = tissue.parts.size();

  const AdjacencyComplex complex = ReconstructComplex(tissue, parameters, result, execution);
  result.tetrahedra = TetrahedraOfImage(complex, tissue);

  Stopwatch stopwatch;
  result.isFitted = volume != nullptr && parameters.fitToImage;
  if (result.isFitted)
  {
    result.walls = FitWalls(complex,
                            tissue.junctions,
                            { *volume, tissue.numbersOfVolume },
                            parameters.refinement > 0 ? parameters.trianglesPerCell : 0.0,
                            &result.fitting,
                            execution.Part(DelaunayShare + OptimizationShare, 1.0));
  }
  else
  {
    result.walls = MakeStarWalls(complex, tissue.junctions, parameters);
  }
  RestoreWalls(complex, tissue, result);

  result.remarks = GatherRemarks(complex, tissue, result, remarks);
  result.dualSeconds = stopwatch.Lap().wallSeconds;
  execution.Report(1.0);
  return result;
}
} // namespace tissue
