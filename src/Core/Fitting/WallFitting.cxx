/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/WallFitting.h"

#include "Common/Algorithms.h"
#include "Fitting/AngleMending.h"
#include "Fitting/CavityVolumes.h"
#include "Fitting/CornerFitting.h"
#include "Fitting/CrossingGuard.h"
#include "Fitting/CrossingWalls.h"
#include "Fitting/OutlineTriangulation.h"
#include "Fitting/TriangleImprovement.h"
#include "Fitting/Untangling.h"
#include "Fitting/VolumeFitting.h"
#include "Fitting/WallFaces.h"
#include "Fitting/WallProjection.h"
#include "Mesh/Crossings.h"
#include "Mesh/WallJoining.h"
#include "Mesh/WallMeshOrder.h"
#include "Mesh/WallPieces.h"
#include "Remeshing/LineSubdivision.h"
#include "Remeshing/WallEdgeLengths.h"
#include "Remeshing/WallRemeshing.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "Mesh/WallMeasures.h"

#include <cmath>
#include <numeric>

namespace tissue
{
namespace
{
/** The most sweeps of the untangling. Real and synthetic stars are free of crossings after far fewer; what is left then
 * stays, and is reported. */
constexpr int UntanglingSweeps = 60;
/** The share of a star's triangles that may cross after the untangling for it to be fitted: what is left after that is
 * mostly for good, and remeshing such a star takes long. */
constexpr double MostShareCrossing = 0.005;
/** The crossing pairs for each triangle of the first star above which the image is one of noise, and nothing is tried.
 * Stars of tissues have a quarter or less. */
constexpr double CrossingsOfNoise = 1.0;
/** The most triangles for each face of the image's voxels. More would tell nothing, and cells of few voxels would be
 * crowded with them. */
constexpr double TrianglesPerFace = 4.0;
/** The largest change of a cell's volume in one step, over the wanted volume: the step is exact to first order only.
 * At the end nothing follows that draws tiny cells away from their volumes again, and few steps are to be enough. */
constexpr double VolumeShare = 0.15;
constexpr double LastVolumeShare = 0.5;
/** Edges grow with a cell's volume to this power, so that small cells get more triangles than their share of the area.
 */
constexpr double SizeExponent = 0.25;
/** What the star takes of the time, and where the last steps towards the volumes begin, for the progress. */
constexpr double StarShare = 0.1;
constexpr double LastStepsShare = 0.85;
/** Steps of the stars towards the volumes, before they are remeshed, and where they stay stars. Bulging walls are far
 * from their volumes at first; but what more steps add by moving corners has to be taken back later. */
constexpr int FirstStarRounds = 3;
constexpr int LastStarRounds = 8;
/** The least and the most rounds of projection, improvement and volumes after the first, the second and the third
 * remeshing. The least are enough where walls are nearly flat; where a round moved the points by more than
 * LargestMeanMove, in voxels, another one follows. */
constexpr int    FewestRounds[] = { 2, 1, 2 };
constexpr int    MostRounds[] = { 4, 2, 4 };
constexpr double LargestMeanMove = 0.15;
/** The most steps towards the volumes at the end. Cells that the guard holds back get there by small steps. */
constexpr int LastVolumeSteps = 10;
/** The relative difference of a cell's volume from the wanted one below which nothing is left to do. */
constexpr double VolumeTolerance = 1e-9;
/** What no step may make sharper: folds in stars and meshes that are to be remeshed, then all that a mesh to be
 * computed on must not have, with a margin for what is not measured alike. */
constexpr AngleLimits Unfolded{ 0.0, 5.0, 0.0 };
constexpr AngleLimits Guarded{ 11.0, 11.0, 0.0 };
/** The shares of its way that a point is set back to, one after the other, while it makes triangles cross. */
const std::vector<double> GuardShares = { 0.3, 0.0 };
/** The same for the centres of the walls when they are lifted to the image, where the ways are long. */
const std::vector<double> LiftShares = { 0.5, 0.25, 0.0 };

/** Whether more pairs cross than so many for each triangle of the mesh. */
bool
IsAbove(double crossingsPerTriangle, const WallFittingStatistics & statistics, const WallMesh & mesh)
{
  return static_cast<double>(statistics.crossingPairs) >
         crossingsPerTriangle * static_cast<double>(mesh.triangles.size());
}

/** Counts the crossings, and for which cells. */
void
RecordCrossings(const WallMesh & mesh, const std::vector<TrianglePair> & crossings, WallFittingStatistics & statistics)
{
  statistics.crossingPairs = static_cast<std::int64_t>(crossings.size());
  statistics.cellsNotFitted.clear();
  for (const TrianglePair & pair : crossings)
  {
    const VertexPair &    first = mesh.walls[mesh.wallOfTriangle[pair[0]]].cells;
    const VertexPair &    second = mesh.walls[mesh.wallOfTriangle[pair[1]]].cells;
    std::vector<VertexId> cells{ first[0], first[1], second[0], second[1] };
    SortUnique(cells);
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(statistics.cellsNotFitted), [](VertexId v) {
      return v != ExteriorVertex;
    });
  }
  std::sort(statistics.cellsNotFitted.begin(), statistics.cellsNotFitted.end());
}

/** \brief Makes the star of a complex's dual and fits it, and the mesh it is remeshed to, to the label image. */
class Fitter
{
public:
  Fitter(const TissueImage & tissue, const Execution & execution)
    : m_Tissue(tissue)
    , m_Field(tissue.cells)
    , m_Execution(execution)
    , m_Volumes(tissue.volumes)
  {
    m_Volumes[ExteriorVertex] = 0.0;
  }

  WallMesh
  MakeStar(ImageDual dual, WallFittingStatistics & statistics)
  {
    this->CountUnfitted(dual, FitCorners(dual, m_Tissue.cellOf, m_Field), statistics);
    this->TakeWallsInOrder(dual.mesh);
    WallMesh          mesh = TriangulateAsStars(dual.mesh);
    const std::size_t numberOfCorners = this->OrderPoints(mesh, dual.mesh.corners.size());
    for (WallMesh::Wall & wall : mesh.walls)
    {
      m_Pairs.push_back(wall.cells);
      wall.cells = { { m_Tissue.cellOf[wall.cells[0]], m_Tissue.cellOf[wall.cells[1]] } };
    }
    RecordCrossings(mesh, FindCrossings(mesh, m_Execution), statistics);
    if (IsAbove(CrossingsOfNoise, statistics, mesh))
    {
      return mesh;
    }
    const double triangleArea = ComputeArea(mesh) / static_cast<double>(mesh.triangles.size());
    m_Faces = CollectWallFaces(mesh, m_Pairs, m_Tissue.vertices);
    this->FindCavities(mesh, statistics);
    this->LiftCenters(mesh);
    m_Execution.Report(0.6 * StarShare);
    // An equilateral triangle of this area has edges as long as this.
    TriangulateFarOutlines(mesh, m_Faces, std::sqrt(triangleArea * 4.0 / std::sqrt(3.0)), m_Execution);
    const UntanglingCounts crossings = Untangle(mesh, UntanglingSweeps, m_Execution);
    statistics.untangledPairs = crossings.before - crossings.after;
    statistics.crossingPairs = crossings.after;
    m_Anchors.assign(mesh.points.begin(), mesh.points.begin() + static_cast<std::ptrdiff_t>(numberOfCorners));
    this->FitStar(mesh, IsHopeless(crossings.after, mesh) ? 0 : FirstStarRounds);
    return mesh;
  }

  void
  FitStar(WallMesh & mesh, int rounds) const
  {
    for (int round = 0; round < rounds; ++round)
    {
      this->VolumeStep(mesh, VolumeShare, Unfolded);
    }
  }

  void
  FitRemeshed(WallMesh & mesh, double trianglesPerCell, WallFittingStatistics & statistics)
  {
    // The mesh is remeshed three times, as its lines and walls grow longer on their way to the image. The rounds after
    // each remeshing project the points, improve the triangles and give the cells their volumes, and take back what
    // makes triangles cross.
    constexpr int meshings = static_cast<int>(std::size(FewestRounds));
    const double  wanted =
      std::min(trianglesPerCell * static_cast<double>(m_Volumes.size() - 1), TrianglesPerFace * this->CountFaces());
    m_Execution.Report(StarShare);
    std::vector<double> lengths = this->RemeshStar(mesh, wanted, statistics);
    double              area = ComputeArea(mesh);
    WallProjection      projection(
      mesh, { m_Tissue.vertices, m_Tissue.cellOf, m_Pairs }, m_Field, m_Faces, lengths, m_Anchors);
    for (int meshing = 0; meshing < meshings; ++meshing)
    {
      if (meshing > 0)
      {
        this->RemeshAgain(mesh, wanted, lengths, area);
        projection.SetWalls(mesh, lengths);
      }
      const double share = (LastStepsShare - StarShare) / meshings;
      const double begin = StarShare + meshing * share;
      bool         isAtRest = false;
      for (int round = 0; round < MostRounds[meshing] && (round < FewestRounds[meshing] || !isAtRest); ++round)
      {
        isAtRest = this->Round(mesh, projection, meshing + 1 == meshings ? Guarded : Unfolded) <= LargestMeanMove;
        m_Execution.Report(begin + share * (round + 1) / MostRounds[meshing]);
      }
    }
    MendAngles(mesh, AngleLimits(), m_Execution);
    for (int step = 0; step < LastVolumeSteps && !this->HasItsVolumes(mesh); ++step)
    {
      this->VolumeStep(mesh, LastVolumeShare, Guarded);
      m_Execution.Report(LastStepsShare + (1.0 - LastStepsShare) * (step + 1) / LastVolumeSteps);
    }
  }

  /** Numbers the corners in the order of the dual. */
  void
  PutCornersInOrder(WallMesh & mesh) const
  {
    std::vector<PointId> order(mesh.points.size());
    std::iota(order.begin(), order.end(), PointId{ 0 });
    std::copy(m_Corners.begin(), m_Corners.end(), order.begin());
    TakePoints(mesh, order);
  }

private:
  /** Leaves out walls within a cell, turns the others as WallMesh has them by their cells, and orders them by the ranks
   * of these. */
  void
  TakeWallsInOrder(DualMesh & dual) const
  {
    const auto & cellOf = m_Tissue.cellOf;
    for (DualMesh::Wall & wall : dual.walls)
    {
      const VertexId first = cellOf[wall.cells[0]];
      const VertexId second = cellOf[wall.cells[1]];
      if (second != ExteriorVertex && (first == ExteriorVertex || second < first))
      {
        TurnOver(wall);
      }
    }
    const auto isWithinCell = [&](const DualMesh::Wall & wall) {
      return cellOf[wall.cells[0]] == cellOf[wall.cells[1]];
    };
    const auto key = [&](const DualMesh::Wall & wall) {
      return VertexPair{ { m_Tissue.ranks[cellOf[wall.cells[0]]], m_Tissue.ranks[cellOf[wall.cells[1]]] } };
    };
    dual.walls.erase(std::remove_if(dual.walls.begin(), dual.walls.end(), isWithinCell), dual.walls.end());
    std::stable_sort(dual.walls.begin(), dual.walls.end(), [&](const DualMesh::Wall & a, const DualMesh::Wall & b) {
      return key(a) < key(b);
    });
  }

  /** Puts the corners first, all in the order of the triangles, and returns their number. */
  std::size_t
  OrderPoints(WallMesh & mesh, std::size_t numberInDual)
  {
    std::vector<PointId> order = PointsByTriangles(mesh);
    const auto           end = std::stable_partition(
      order.begin(), order.end(), [&](PointId p) { return mesh.numberOfCells[p] == CellsAtCorner; });
    TakePoints(mesh, order);
    std::vector<PointId> placeOf(numberInDual, -1);
    for (auto corner = order.begin(); corner != end; ++corner)
    {
      placeOf[*corner] = static_cast<PointId>(corner - order.begin());
    }
    std::copy_if(
      placeOf.begin(), placeOf.end(), std::back_inserter(m_Corners), [](PointId place) { return place >= 0; });
    return m_Corners.size();
  }

  void
  CountUnfitted(const ImageDual & dual, const std::vector<std::size_t> & corners,
                WallFittingStatistics & statistics) const
  {
    statistics.unfittedCorners = static_cast<std::int64_t>(corners.size());
    statistics.unfittedCornersOfCell.assign(m_Volumes.size(), 0);
    for (const std::size_t corner : corners)
    {
      for (const VertexId v : dual.mesh.cellsOfCorner[corner])
      {
        ++statistics.unfittedCornersOfCell[m_Tissue.cellOf[v]];
      }
    }
  }

  void
  FindCavities(const WallMesh & mesh, WallFittingStatistics & statistics)
  {
    CavityVolumes cavities = FindCavityVolumes(mesh, m_Volumes.size(), m_Tissue.cells);
    m_CavityOfWall = std::move(cavities.ofWall);
    m_VolumesWithin = m_Volumes;
    m_VolumesWithin.insert(m_VolumesWithin.end(), cavities.volumes.begin(), cavities.volumes.end());
    statistics.cellsOfFilledVoids = std::move(cavities.cellsOfFilledVoids);
  }

  /** A step of cells, and of the cavities in them, towards their volumes. */
  void
  StepTowardsVolumes(WallMesh & mesh, double share) const
  {
    const std::vector<WallMesh::Wall> walls = mesh.walls;
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
      if (m_CavityOfWall[w] != ExteriorVertex)
      {
        mesh.walls[w].cells[1] = m_CavityOfWall[w];
      }
    }
    FitVolumes(mesh, m_VolumesWithin, share);
    mesh.walls = walls;
  }

  /** Each wall's centre goes towards the mean of its faces in the image, as far as nothing more crosses. */
  void
  LiftCenters(WallMesh & mesh) const
  {
    const std::vector<Point>       before = mesh.points;
    const std::vector<std::size_t> first = FirstTrianglesOfWalls(mesh);
    for (std::size_t w = 0; w < mesh.walls.size(); ++w)
    {
      Point sum{ { 0.0, 0.0, 0.0 } };
      for (const ImagePlaces::Place * face = m_Faces.Begin(w); face != m_Faces.End(w); ++face)
      {
        sum = sum + Point{ { (*face)[0], (*face)[1], (*face)[2] } };
      }
      if (m_Faces.Begin(w) != m_Faces.End(w))
      {
        mesh.points[mesh.triangles[first[w]][0]] = (1.0 / static_cast<double>(m_Faces.End(w) - m_Faces.Begin(w))) * sum;
      }
    }
    StepBackFromCrossings(mesh, before, LiftShares, Unfolded, m_Execution);
  }

  /** One round towards the image. Returns the mean length of the points' moves, in voxels, that the projection made. */
  double
  Round(WallMesh & mesh, const WallProjection & projection, const AngleLimits & limits) const
  {
    const std::vector<Point> before = mesh.points;
    projection.Move(mesh, m_Execution);
    double sum = 0.0;
    for (std::size_t p = 0; p < before.size(); ++p)
    {
      sum += m_Field.LengthInVoxels(mesh.points[p] - before[p]);
    }
    ImproveTriangles(mesh, 1, m_Execution);
    this->StepTowardsVolumes(mesh, VolumeShare);
    StepBackFromCrossings(mesh, before, GuardShares, limits, m_Execution);
    return sum / static_cast<double>(before.size());
  }

  void
  VolumeStep(WallMesh & mesh, double share, const AngleLimits & limits) const
  {
    const std::vector<Point> before = mesh.points;
    this->StepTowardsVolumes(mesh, share);
    StepBackFromCrossings(mesh, before, GuardShares, limits, m_Execution);
  }

  bool
  HasItsVolumes(const WallMesh & mesh) const
  {
    const std::vector<double> volumes = ComputeVolumes(mesh, m_Volumes.size());
    for (std::size_t v = 0; v < volumes.size(); ++v)
    {
      if (std::abs(volumes[v] - m_Volumes[v]) > VolumeTolerance * m_Volumes[v])
      {
        return false;
      }
    }
    return true;
  }

  double
  CountFaces() const
  {
    std::ptrdiff_t count = 0;
    for (std::size_t wall = 0; wall < m_Pairs.size(); ++wall)
    {
      count += m_Faces.End(wall) - m_Faces.Begin(wall);
    }
    return static_cast<double>(count);
  }

  std::vector<double>
  RemeshStar(WallMesh & mesh, double wanted, WallFittingStatistics & statistics) const
  {
    const std::vector<double> factors = EdgeLengthFactorsByCell(mesh, m_Volumes, SizeExponent);
    WallMesh                  star = mesh;
    const std::vector<double> lengths = RemeshToNumberOfTriangles(mesh, wanted, factors, m_Execution);
    SubdivideLines(star, lengths);
    SubdivideWalls(star, lengths, m_Execution);
    statistics.starWalls = MendCrossingWalls(mesh, star, SmoothedPoints::WholeWalls, m_Execution);
    // Stars whose lines have got points may cross others again.
    if (statistics.starWalls > 0)
    {
      Untangle(mesh, UntanglingSweeps, m_Execution);
    }
    return lengths;
  }

  /** Within the lines as they are; the walls' areas have changed, and so does the number of triangles of a length. */
  void
  RemeshAgain(WallMesh & mesh, double wanted, std::vector<double> & lengths, double & area) const
  {
    const WallMesh old = mesh;
    const double   ratio = static_cast<double>(old.triangles.size()) / wanted;
    const double   growth = ComputeArea(mesh) / area;
    for (double & length : lengths)
    {
      length *= std::sqrt(ratio * growth);
    }
    area = ComputeArea(mesh);
    RemeshWalls(mesh, lengths, m_Execution);
    MendCrossingWalls(mesh, old, SmoothedPoints::AroundCrossings, m_Execution);
  }

  const TissueImage & m_Tissue;
  IndicatorField      m_Field;
  const Execution &   m_Execution;
  std::vector<double> m_Volumes;
  /** Of each wall its vertices in the complex. */
  std::vector<VertexPair> m_Pairs;
  ImagePlaces             m_Faces{ 0, {} };
  /** Of each wall the cavity beyond it, or ExteriorVertex; and the volumes, with those of the cavities at the end. */
  std::vector<VertexId> m_CavityOfWall;
  std::vector<double>   m_VolumesWithin;
  /** Where the corners are fitted and apart. */
  std::vector<Point> m_Anchors;
  /** In the order of the dual, the points of the mesh. */
  std::vector<PointId> m_Corners;
};

/** The fitted walls of the complex, and whether they have been remeshed. */
std::pair<WallMesh, bool>
FitWallsOfComplex(ImageDual dual, const TissueImage & tissue, double trianglesPerCell, WallFittingStatistics & s,
                  const Execution & execution)
{
  execution.EnterPhase("Making the walls");
  Fitter   fitter(tissue, execution);
  WallMesh mesh = fitter.MakeStar(std::move(dual), s);
  execution.EnterPhase("Fitting the walls");
  const bool isHopeless = IsAbove(MostShareCrossing, s, mesh);
  const bool isRemeshed = trianglesPerCell > 0.0 && !isHopeless;
  if (isRemeshed)
  {
    fitter.FitRemeshed(mesh, trianglesPerCell, s);
  }
  else if (!isHopeless)
  {
    fitter.FitStar(mesh, LastStarRounds);
  }
  fitter.PutCornersInOrder(mesh);
  return { std::move(mesh), isRemeshed };
}
} // namespace

WallMesh
FitWalls(ImageDual dual, const TissueImage & tissue, double trianglesPerCell, WallFittingStatistics * statistics,
         const Execution & execution)
{
  WallFittingStatistics   own;
  WallFittingStatistics & s = statistics != nullptr ? *statistics : own;
  auto [mesh, isRemeshed] = FitWallsOfComplex(std::move(dual), tissue, trianglesPerCell, s, execution);
  const bool isOfNoise = IsAbove(CrossingsOfNoise, s, mesh);
  JoinWalls(mesh);
  if (isRemeshed)
  {
    s.sharpPlaces = FindSharpPlaces(mesh, AngleLimits());
  }
  if (!isOfNoise)
  {
    RecordCrossings(mesh, FindCrossings(mesh, execution), s);
  }
  return std::move(mesh);
}
} // namespace tissue
