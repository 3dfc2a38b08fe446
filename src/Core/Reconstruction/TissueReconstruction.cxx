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
TetrahedralizeParts(const TissueParts & parts, const std::vector<Point> & centers)
{
  std::vector<VertexQuadruple> tetrahedra;
  for (const std::vector<VertexId> & part : parts.parts)
  {
    std::vector<VertexId> vertices{ ExteriorVertex };
    vertices.insert(vertices.end(), part.begin(), part.end());
    std::vector<Point> points;
    for (const VertexId v : vertices)
    {
      points.push_back(centers[v]);
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

/** The complex through its stages, which `result` learns of. Works on vertices in spatial order: on large tissues much
 * of the time would go to fetching what lies far apart. */
AdjacencyComplex
ReconstructComplex(const JunctionSet & junctions, const TissueParts & parts, const std::vector<Point> & centersById,
                   const ReconstructionParameters & parameters, TissueReconstruction & result,
                   const Execution & execution)
{
  Stopwatch                   stopwatch;
  const std::vector<VertexId> order = SpatialOrder(centersById);
  const std::vector<VertexId> ranks = RanksInOrder(order);
  std::vector<Point>          centers;
  for (const VertexId v : order)
  {
    centers.push_back(centersById[v]);
  }
  const ReferenceAdjacency reference = ReferenceAdjacency(junctions).Renumbered(ranks);
  // The statistics of a stage do not count for the time of the next one.
  const auto finishStage = [&](const AdjacencyComplex & complex) {
    ReconstructionStage stage;
    stage.seconds = stopwatch.Lap().wallSeconds;
    stage.statistics = ComputeStatistics(complex, centers, &reference, parameters.energy);
    if (parameters.keepStages)
    {
      stage.tetrahedra = MergeVoids(Renumbered(complex.GetTetrahedra(), order), junctions);
    }
    stopwatch.Lap().wallSeconds;
    return stage;
  };

  const auto       numberOfVertices = static_cast<VertexId>(centers.size());
  AdjacencyComplex complex(numberOfVertices, Renumbered(TetrahedralizeParts(parts, centersById), ranks));
  result.delaunay = finishStage(complex);
  execution.Report(DelaunayShare);

  const SurfaceCleanUpParameters cleanUp = MakeCleanUp(junctions, parameters, complex, centers);
  result.maximumEdgeLength =
    cleanUp.maximumEdgeLength * (cleanUp.localLengths.empty() ? 1.0 : MedianSpacing(cleanUp.localLengths));
  result.cleanUp = CleanSurface(complex, centers, &reference, cleanUp);
  result.cleaned = finishStage(complex);

  TopologyOptimizer optimizer(complex, centers, &reference, parameters.energy, parameters.annealing);
  result.cycles = optimizer.Run(execution.Part(DelaunayShare, DelaunayShare + OptimizationShare));
  result.numberOfRelocatedVertices = optimizer.NumberOfRelocatedVertices();
  result.energy = optimizer.Energy();
  result.optimized = finishStage(complex);
  return AdjacencyComplex(numberOfVertices, Renumbered(complex.GetTetrahedra(), order));
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

WallMesh
MakeWalls(const AdjacencyComplex & complex, const JunctionSet & junctions, const ReconstructionParameters & parameters)
{
  WallMesh walls = TriangulateAsStars(Dualize(complex, ComputeCorners(complex, junctions, parameters.corners)));
  for (int level = 0; level < parameters.refinement; ++level)
  {
    SplitTriangles(walls);
  }
  SmoothWalls(walls, parameters.smoothingIterations);
  return walls;
}
} // namespace

TissueReconstruction
ReconstructTissue(const JunctionSet & image, const ReconstructionParameters & parameters, const LabelVolume * volume,
                  const Execution & execution)
{
  parameters.Check();
  if (!parameters.separateVoids && !image.voids.empty())
  {
    const LabelVolume merged = volume != nullptr ? MergeVoids(*volume, image.cells.size()) : LabelVolume();
    return ReconstructTissue(MergeVoids(image), parameters, volume != nullptr ? &merged : nullptr, execution);
  }
  TissueReconstruction     result;
  std::vector<CellRemark>  remarks;
  const std::vector<Point> centers = SeparateCenters(image, remarks);
  const TissueParts        parts = parameters.separateParts ? FindTissueParts(image, centers) : JoinTissueParts(image);
  JunctionSet              ofParts;
  if (parts.parts.size() > 1 && !image.voids.empty())
  {
    ofParts = MergeVoidsOfOtherParts(image, parts.PartOfVertex(image.NumberOfVertices()));
  }
  const JunctionSet & junctions = ofParts.cells.empty() ? image : ofParts;
  result.numberOfVoids = junctions.voids.size();
  result.numberOfParts = parts.parts.size();
  const AdjacencyComplex complex = ReconstructComplex(junctions, parts, centers, parameters, result, execution);

  Stopwatch stopwatch;
  result.tetrahedra = MergeVoids(complex.GetTetrahedra(), junctions);
  result.isFitted = volume != nullptr && parameters.fitToImage;
  const double trianglesPerCell = parameters.refinement > 0 ? parameters.trianglesPerCell : 0.0;
  result.walls = result.isFitted ? FitWalls(complex,
                                            junctions,
                                            *volume,
                                            trianglesPerCell,
                                            &result.fitting,
                                            execution.Part(DelaunayShare + OptimizationShare, 1.0))
                                 : MakeWalls(complex, junctions, parameters);
  MergeVoids(result.walls, junctions);
  for (const VertexId cell : parts.strayCells)
  {
    remarks.push_back({ cell, Remark::StrayPart, 0.0 });
  }
  if (!junctions.walls.empty())
  {
    RemarkVolumes(result.walls, junctions, result.isFitted, remarks);
    result.remarks = CollectRemarks(complex, junctions);
  }
  for (std::size_t v = ExteriorVertex + 1;
       v < std::min(junctions.cells.size(), result.fitting.unfittedCornersOfCell.size());
       ++v)
  {
    if (result.fitting.unfittedCornersOfCell[v] > 0)
    {
      remarks.push_back({ static_cast<VertexId>(v),
                          Remark::CornersNotFitted,
                          static_cast<double>(result.fitting.unfittedCornersOfCell[v]) });
    }
  }
  result.remarks.insert(result.remarks.end(), remarks.begin(), remarks.end());
  std::stable_sort(result.remarks.begin(), result.remarks.end(), [](const CellRemark & a, const CellRemark & b) {
    return a.cell < b.cell;
  });
  result.dualSeconds = stopwatch.Lap().wallSeconds;
  execution.Report(1.0);
  return result;
}
} // namespace tissue
