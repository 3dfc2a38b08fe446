/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

#include "Adjacency/ReferenceAdjacency.h"
#include "Adjacency/TissueParts.h"
#include "Complex/DelaunayTetrahedralization.h"
#include "Complex/LocalSpacing.h"
#include "Dual/CellCorners.h"
#include "Dual/DualMesh.h"
#include "Geometry/SpatialOrder.h"
#include "Optimization/TopologyOptimizer.h"
#include "Reconstruction/VoidMerging.h"
#include "Remeshing/WallRefinement.h"
#include "TissueTessellationCore/Adjacency/Voids.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
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

/** What the pipeline works on, by the vertices of the image. */
struct Tissue
{
  /** Those of the image, with the voids merged that are not to be vertices. */
  JunctionSet        junctions;
  std::vector<Point> centers;
  TissueParts        parts;
  /** The vertices in spatial order, and the rank of each in it. Complex and walls are worked on in this order: on large
   * tissues much of the time would else go to fetching what lies far apart. */
  std::vector<VertexId> order;
  std::vector<VertexId> ranks;
};

/** The door: decides on voids and parts, and orders the vertices. */
Tissue
EnterTissue(const JunctionSet & image, const ReconstructionParameters & parameters, std::vector<CellRemark> & remarks)
{
  Tissue tissue;
  tissue.junctions = parameters.separateVoids ? image : MergeVoids(image);
  tissue.centers = SeparateCenters(tissue.junctions, remarks);
  tissue.parts =
    parameters.separateParts ? FindTissueParts(tissue.junctions, tissue.centers) : JoinTissueParts(tissue.junctions);
  for (const VertexId cell : tissue.parts.strayCells)
  {
    remarks.push_back({ cell, Remark::StrayPart, 0.0 });
  }
  if (tissue.parts.parts.size() > 1 && !tissue.junctions.voids.empty())
  {
    const auto partOfVertex = tissue.parts.PartOfVertex(tissue.junctions.NumberOfVertices());
    tissue.junctions = MergeVoidsOfOtherParts(tissue.junctions, partOfVertex);
  }
  tissue.order = SpatialOrder(tissue.centers);
  tissue.ranks = RanksInOrder(tissue.order);
  return tissue;
}

/** The tetrahedra over vertices by other ids: ids[v] for v. */
std::vector<VertexQuadruple>
Renumbered(std::vector<VertexQuadruple> tetrahedra, const std::vector<VertexId> & ids)
{
  for (VertexQuadruple & tetrahedron : tetrahedra)
  {
    for (VertexId & v : tetrahedron)
    {
      v = ids[v];
    }
    tetrahedron = Canonical(tetrahedron);
  }
  std::sort(tetrahedra.begin(), tetrahedra.end());
  return tetrahedra;
}

/** The Delaunay tetrahedralization of each part of the tissue, closed by the exterior. */
std::vector<VertexQuadruple>
TetrahedralizeParts(const Tissue & tissue)
{
  std::vector<VertexQuadruple> tetrahedra;
  for (const std::vector<VertexId> & part : tissue.parts.parts)
  {
    std::vector<VertexId> vertices{ ExteriorVertex };
    vertices.insert(vertices.end(), part.begin(), part.end());
    std::vector<Point> points;
    for (const VertexId v : vertices)
    {
      points.push_back(tissue.centers[v]);
    }
    const auto ofPart = Renumbered(DelaunayTetrahedralization(points), vertices);
    tetrahedra.insert(tetrahedra.end(), ofPart.begin(), ofPart.end());
  }
  return tetrahedra;
}

/** How the Delaunay complex is to be cleaned. */
SurfaceCleanUpParameters
MakeCleanUp(const JunctionSet & junctions, const ReconstructionParameters & parameters,
            const AdjacencyComplex & complex, const std::vector<Point> & centers)
{
  SurfaceCleanUpParameters cleanUp;
  cleanUp.guidedByReference = parameters.guidedCleanUp;
  cleanUp.maximumEdgeLength = parameters.maximumEdgeLength;
  if (!(parameters.maximumEdgeLength > 0.0))
  {
    const double median = parameters.localMaximumEdgeLength ? 0.0 : MedianNeighborDistance(junctions);
    cleanUp.maximumEdgeLength = parameters.maximumEdgeLengthFactor * (median > 0.0 ? median : 1.0);
    cleanUp.localLengths = median > 0.0 ? std::vector<double>() : LocalSpacings(complex, centers);
  }
  return cleanUp;
}

/** The complex through its stages, which `result` learns of. The vertices are renumbered by their ranks on the way in,
 * and back on the way out. */
AdjacencyComplex
ReconstructComplex(const Tissue & tissue, const ReconstructionParameters & parameters, TissueReconstruction & result,
                   const Execution & execution)
{
  Stopwatch          stopwatch;
  std::vector<Point> centers;
  for (const VertexId v : tissue.order)
  {
    centers.push_back(tissue.centers[v]);
  }
  const ReferenceAdjacency reference = ReferenceAdjacency(tissue.junctions).Renumbered(tissue.ranks);
  // The statistics of a stage do not count for the time of the next one.
  const auto finishStage = [&](const AdjacencyComplex & complex) {
    ReconstructionStage stage;
    stage.seconds = stopwatch.Lap().wallSeconds;
    stage.statistics = ComputeStatistics(complex, centers, &reference, parameters.energy);
    if (parameters.keepStages)
    {
      stage.tetrahedra = MergeVoids(Renumbered(complex.GetTetrahedra(), tissue.order), tissue.junctions);
    }
    stopwatch.Lap();
    return stage;
  };

  const auto       numberOfVertices = static_cast<VertexId>(centers.size());
  AdjacencyComplex complex(numberOfVertices, Renumbered(TetrahedralizeParts(tissue), tissue.ranks));
  result.delaunay = finishStage(complex);
  execution.Report(DelaunayShare);

  const SurfaceCleanUpParameters cleanUp = MakeCleanUp(tissue.junctions, parameters, complex, centers);
  result.maximumEdgeLength =
    cleanUp.maximumEdgeLength * (cleanUp.localLengths.empty() ? 1.0 : MedianSpacing(cleanUp.localLengths));
  result.cleanUp = CleanSurface(complex, centers, &reference, cleanUp);
  result.cleaned = finishStage(complex);

  TopologyOptimizer optimizer(complex, centers, &reference, parameters.energy, parameters.annealing);
  result.cycles = optimizer.Run(execution.Part(DelaunayShare, DelaunayShare + OptimizationShare));
  result.numberOfRelocatedVertices = optimizer.NumberOfRelocatedVertices();
  result.energy = optimizer.Energy();
  result.optimized = finishStage(complex);
  return AdjacencyComplex(numberOfVertices, Renumbered(complex.GetTetrahedra(), tissue.order));
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
GatherRemarks(const AdjacencyComplex & complex, const JunctionSet & junctions, const TissueReconstruction & result,
              const std::vector<CellRemark> & door)
{
  const bool              hasWalls = !junctions.walls.empty();
  std::vector<CellRemark> remarks = hasWalls ? CollectRemarks(complex, junctions) : std::vector<CellRemark>();
  remarks.insert(remarks.end(), door.begin(), door.end());
  if (hasWalls)
  {
    RemarkVolumes(result.walls, junctions, result.isFitted, remarks);
  }
  RemarkCorners(result.fitting.unfittedCornersOfCell, junctions.cells.size(), remarks);
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
  const Tissue            tissue = EnterTissue(image, parameters, remarks);
  result.numberOfVoids = tissue.junctions.voids.size();
  result.numberOfParts = tissue.parts.parts.size();
  const AdjacencyComplex complex = ReconstructComplex(tissue, parameters, result, execution);

  Stopwatch stopwatch;
  result.isFitted = volume != nullptr && parameters.fitToImage;
  if (result.isFitted)
  {
    const bool        isMerged = tissue.junctions.voids.size() < image.voids.size();
    const LabelVolume merged = isMerged ? MergeVoids(*volume, image.cells.size()) : LabelVolume();
    result.walls = FitWalls(complex,
                            tissue.junctions,
                            isMerged ? merged : *volume,
                            tissue.ranks,
                            parameters.refinement > 0 ? parameters.trianglesPerCell : 0.0,
                            &result.fitting,
                            execution.Part(DelaunayShare + OptimizationShare, 1.0));
  }
  else
  {
    result.walls = MakeStarWalls(complex, tissue.junctions, parameters);
  }

  // The exit: voids are the exterior from here on.
  result.tetrahedra = MergeVoids(complex.GetTetrahedra(), tissue.junctions);
  MergeVoids(result.walls, tissue.junctions);

  result.remarks = GatherRemarks(complex, tissue.junctions, result, remarks);
  result.dualSeconds = stopwatch.Lap().wallSeconds;
  execution.Report(1.0);
  return result;
}
} // namespace tissue
