/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

#include "Common/Algorithms.h"
#include "Dual/EmbeddedWalls.h"
#include "Fitting/WallFitting.h"
#include "Geometry/SpatialOrder.h"
#include "Mesh/Cavities.h"
#include "Mesh/Crossings.h"
#include "Mesh/WallMeasures.h"
#include "Reconstruction/TissueComplex.h"
#include "Remeshing/WallRefinement.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
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

/** The fewest voxels of a cell, on average, for which walls can be fitted: those of a cube of two a side. */
constexpr double FewestVoxelsToFit = 8.0;
/** The most triangles of stars for each face of voxels in walls. More are those of noise; they cross so often that even
 * to count how often takes long. */
constexpr double MostStarTrianglesPerFace = 1.5;
/** The share of the cells whose walls may cross, or that may be inside out, for the others to keep their fitted walls:
 * users would rather lose a few cells of a large tissue, and be told which, than all smooth walls. */
constexpr double MostShareNotFitted = 0.01;
/** The most triangles of walls that are not fitted, in all and for each cell: those of all images but large ones. */
constexpr std::int64_t MostEmbeddedTriangles = 1000000;
constexpr std::int64_t MostEmbeddedTrianglesPerCell = 500;

/** The image by the vertices of the complex. */
const LabelVolume &
VolumeOf(const TissueComplex & complex, const LabelVolume & volume)
{
  return complex.volume.vertices.empty() ? volume : complex.volume;
}

WallMesh
MakeFittedWalls(TissueComplex & complex, const TissueCells & cells, const LabelVolume & volume,
                const ReconstructionParameters & parameters, WallFittingStatistics & statistics,
                const Execution & execution)
{
  std::vector<double> volumes;
  for (const Cell & cell : cells.junctions.cells)
  {
    volumes.push_back(cell.volume);
  }
  return FitWalls(std::move(complex.dual),
                  { volume, VolumeOf(complex, volume), complex.cellOf, volumes, cells.ranks },
                  parameters.refinement > 0 ? parameters.trianglesPerCell : 0.0,
                  &statistics,
                  execution);
}

/** Adds the cells that are inside out. */
void
AddInvertedCells(const WallMesh & walls, std::size_t numberOfCells, std::vector<VertexId> & cells)
{
  const std::vector<double> volumes = ComputeVolumes(walls, numberOfCells);
  for (std::size_t v = ExteriorVertex + 1; v < numberOfCells; ++v)
  {
    if (!(volumes[v] > 0.0))
    {
      cells.push_back(static_cast<VertexId>(v));
    }
  }
  std::sort(cells.begin(), cells.end());
}

/** Whether the stars of the walls would have more triangles than the image can tell of. */
bool
IsNoise(const TissueComplex & complex, const std::vector<Wall> & walls)
{
  double triangles = 0.0;
  for (const DualMesh::Wall & wall : complex.dual.mesh.walls)
  {
    const bool isWithin = complex.cellOf[wall.cells[0]] == complex.cellOf[wall.cells[1]];
    triangles += isWithin ? 0.0 : static_cast<double>(wall.corners.size());
  }
  double faces = 0.0;
  for (const Wall & wall : walls)
  {
    faces += static_cast<double>(wall.numberOfFaces);
  }
  return triangles > MostStarTrianglesPerFace * faces;
}

/** Takes the walls of the voxels, as those of some cells cannot be fitted. Returns what touches what in them. */
AdjacencyTuples
EmbedWalls(const TissueComplex & complex, const TissueCells & cells, const LabelVolume & volume,
           const ReconstructionParameters & parameters, std::vector<VertexId> notFitted, TissueReconstruction & result)
{
  Stopwatch     stopwatch;
  EmbeddedWalls embedded = MakeEmbeddedWalls(VolumeOf(complex, volume), complex.cellOf);
  result.walls = std::move(embedded.mesh);
  result.tetrahedra = std::move(embedded.tetrahedra);
  result.fitting = WallFittingStatistics();
  result.fitting.isEmbedded = true;
  result.fitting.cellsNotFitted = std::move(notFitted);
  AdjacencyTuples tuples = AdjacencyTuples::Of(result.tetrahedra, CellsOfWalls(result.walls));
  result.stages.push_back(
    MakeStage("embedded", stopwatch.Lap().wallSeconds, result.tetrahedra, tuples, cells, parameters));
  return tuples;
}

/** Whether the walls of the voxels are not too many triangles; takes a pass over the voxels. */
bool
MayEmbed(const TissueComplex & complex, std::size_t numberOfCells, const LabelVolume & volume)
{
  return CountEmbeddedTriangles(VolumeOf(complex, volume), complex.cellOf) <=
         MostEmbeddedTriangles + MostEmbeddedTrianglesPerCell * static_cast<std::int64_t>(numberOfCells);
}

/** The cells for which the walls of an image are not worth fitting: all of one of noise, and specks. */
std::vector<VertexId>
FindCellsNotToFit(const TissueComplex & complex, const JunctionSet & junctions)
{
  if (!IsNoise(complex, junctions.walls))
  {
    return FindSpecks(junctions.cells);
  }
  std::vector<VertexId> cells(junctions.cells.size() - 1);
  std::iota(cells.begin(), cells.end(), ExteriorVertex + 1);
  return cells;
}

/** The cells whose fitted walls cross, or that are inside out, each as often as that is so; none where they are few. */
std::vector<VertexId>
FindCellsNotFitted(const TissueReconstruction & result, std::size_t numberOfCells)
{
  std::vector<VertexId> places = result.fitting.cellsNotFitted;
  AddInvertedCells(result.walls, numberOfCells, places);
  std::vector<VertexId> cells = places;
  SortUnique(cells);
  const bool areFew = static_cast<double>(cells.size()) < MostShareNotFitted * static_cast<double>(numberOfCells);
  return areFew ? std::vector<VertexId>() : places;
}

/** Fits the walls to the image, or takes those of its voxels, where the complex is from the image: where fitted ones
 * cross or turn cells inside out, more than a few, and in an image of specks. Returns what touches what. */
AdjacencyTuples
MakeWallsOfImage(TissueComplex & complex, const TissueCells & cells, const LabelVolume & volume,
                 const ReconstructionParameters & parameters, TissueReconstruction & result,
                 const Execution & execution)
{
  const std::size_t     numberOfCells = cells.junctions.cells.size();
  const bool            isOfImage = parameters.source == ComplexSource::Image;
  std::vector<VertexId> notFitted = isOfImage ? FindCellsNotToFit(complex, cells.junctions) : std::vector<VertexId>();
  if (notFitted.empty() || !MayEmbed(complex, numberOfCells, volume))
  {
    result.walls = MakeFittedWalls(complex, cells, volume, parameters, result.fitting, execution);
    notFitted = isOfImage ? FindCellsNotFitted(result, numberOfCells) : std::vector<VertexId>();
    if (notFitted.empty() || !MayEmbed(complex, numberOfCells, volume))
    {
      return complex.tuples;
    }
  }
  return EmbedWalls(complex, cells, volume, parameters, std::move(notFitted), result);
}

/** Names the cells whose volume is far from that in the image, and those with handles that were not known of. */
void
RemarkSurfaces(const WallMesh & walls, const JunctionSet & junctions, bool isFitted, std::vector<CellRemark> & remarks)
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
  std::set<VertexId> known;
  for (const CellRemark & remark : remarks)
  {
    if (remark.remark == Remark::HandlesKept)
    {
      known.insert(remark.cell);
    }
  }
  for (const VertexId v : check.cellsThatAreNoSphere)
  {
    const CellSurface & surface = check.cells[v];
    if (surface.IsClosed() && known.count(v) == 0)
    {
      const int handles = (2 * surface.numberOfComponents - surface.eulerCharacteristic) / 2;
      remarks.push_back({ v, Remark::HandlesKept, static_cast<double>(handles) });
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
    RemarkSurfaces(result.walls, junctions, result.isFitted, remarks);
  }
  RemarkCounts(CellsOfCavities(result.walls), Remark::Cavities, remarks);
  RemarkCounts(result.fitting.cellsOfFilledVoids, Remark::CavitiesFilled, remarks);
  RemarkCorners(result.fitting.unfittedCornersOfCell, junctions.cells.size(), remarks);
  if (result.fitting.isEmbedded)
  {
    RemarkCounts(result.fitting.cellsNotFitted, Remark::VoxelWalls, remarks);
  }
  RemarkCounts(CellsOfSharpPlaces(result), Remark::Sharp, remarks);
  std::stable_sort(
    remarks.begin(), remarks.end(), [](const CellRemark & a, const CellRemark & b) { return a.cell < b.cell; });
  return remarks;
}
} // namespace

std::vector<VertexId>
FindSpecks(const std::vector<Cell> & cells)
{
  std::int64_t          numberOfVoxels = 0;
  std::vector<VertexId> specks;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    numberOfVoxels += cells[v].numberOfVoxels;
    if (static_cast<double>(cells[v].numberOfVoxels) < FewestVoxelsToFit)
    {
      specks.push_back(static_cast<VertexId>(v));
    }
  }
  const bool isOfSpecks =
    static_cast<double>(numberOfVoxels) < FewestVoxelsToFit * static_cast<double>(cells.size() - 1);
  return isOfSpecks ? specks : std::vector<VertexId>();
}

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

  Stopwatch       stopwatch;
  AdjacencyTuples tuples = complex.tuples;
  result.isFitted = volume != nullptr && parameters.fitToImage;
  if (result.isFitted)
  {
    tuples = MakeWallsOfImage(complex, cells, *volume, parameters, result, execution.Part(ComplexShare, 1.0));
  }
  else
  {
    result.walls = MakeStarWalls(complex.dual.mesh, parameters);
    result.fitting.crossingPairs = static_cast<std::int64_t>(FindCrossings(result.walls, execution).size());
  }
  result.remarks = GatherRemarks(tuples, junctions, result);
  result.dualSeconds = stopwatch.Lap().wallSeconds;
  execution.Report(1.0);
  return result;
}
} // namespace tissue
