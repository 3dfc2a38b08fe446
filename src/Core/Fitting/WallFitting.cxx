/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Fitting/WallFitting.h"

#include "Complex/AdjacencyComplex.h"
#include "Dual/DualMesh.h"
#include "Fitting/CornerFitting.h"
#include "Fitting/CrossingGuard.h"
#include "Fitting/CrossingWalls.h"
#include "Fitting/OutlineTriangulation.h"
#include "Fitting/TriangleImprovement.h"
#include "Fitting/Untangling.h"
#include "Fitting/VolumeFitting.h"
#include "Fitting/WallProjection.h"
#include "Mesh/Crossings.h"
#include "Mesh/WallMeshOrder.h"
#include "Remeshing/LineSubdivision.h"
#include "Remeshing/WallEdgeLengths.h"
#include "Remeshing/WallRemeshing.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallMeasures.h"

#include <cmath>
#include <numeric>

namespace tissue
{
namespace
{
/** The most sweeps of the untangling. Real and synthetic stars are free of crossings after far fewer; what is left then
 * stays, and is reported. */
constexpr int UntanglingSweeps = 60;
/** The largest change of a cell's volume in one step, over the wanted volume: the step is exact to first order only. */
constexpr double VolumeShare = 0.15;
/** Edges grow with a cell's volume to this power, so that small cells get more triangles than their share of the area.
 */
constexpr double SizeExponent = 0.25;
/** What the star takes of the time, for the progress. */
constexpr double StarShare = 0.1;
/** Steps towards the volumes where the walls stay stars. */
constexpr int StarRounds = 8;
/** The rounds of projection, improvement and volumes after the first, the second and the third remeshing. */
constexpr int RoundsPerMeshing[] = { 4, 2, 4 };
/** The most steps towards the volumes at the end. Cells that the guard holds back get there by small steps. */
constexpr int LastVolumeSteps = 10;
/** The relative difference of a cell's volume from the wanted one below which nothing is left to do. */
constexpr double VolumeTolerance = 1e-9;
/** The shares of its way that a point is set back to, one after the other, while it makes triangles cross. */
const std::vector<double> GuardShares = { 0.3, 0.0 };
/** The same for the centres of the walls when they are lifted to the image, where the ways are long. */
const std::vector<double> LiftShares = { 0.5, 0.25, 0.0 };

/** \brief Makes the star of a complex's dual and fits it, and the mesh it is remeshed to, to the label image. */
class Fitter
{
public:
  Fitter(const JunctionSet & junctions, const LabelVolume & volume, const std::vector<VertexId> & ranks,
         const Execution & execution)
    : m_Junctions(junctions)
    , m_Volume(volume)
    , m_Ranks(ranks)
    , m_Field(volume)
    , m_Execution(execution)
  {
    for (VertexId v = 0; v < junctions.NumberOfVertices(); ++v)
    {
      m_Volumes.push_back(junctions.CellOfVertex(v).volume);
    }
    m_Volumes[ExteriorVertex] = 0.0;
  }

  WallMesh
  MakeStar(const AdjacencyComplex & complex, WallFittingStatistics & statistics)
  {
    std::vector<std::size_t> unfitted;
    WallMesh          mesh = TriangulateAsStars(Dualize(complex, FitCorners(complex, m_Junctions, m_Field, &unfitted)));
    const std::size_t numberOfCorners = mesh.points.size() - mesh.walls.size();
    this->OrderSpatially(mesh, numberOfCorners);
    const double triangleArea = ComputeArea(mesh) / static_cast<double>(mesh.triangles.size());
    m_Faces = CollectImageFaces(m_Volume, CellsOfWalls(mesh));
    // An equilateral triangle of this area has edges as long as this.
    TriangulateFarOutlines(mesh, m_Faces, std::sqrt(triangleArea * 4.0 / std::sqrt(3.0)), m_Execution);
    this->CountUnfitted(complex, unfitted, statistics);
    statistics.untangledPairs = static_cast<std::int64_t>(FindCrossings(mesh, m_Execution).size());
    statistics.crossingPairs = Untangle(mesh, UntanglingSweeps, m_Execution);
    statistics.untangledPairs -= statistics.crossingPairs;
    m_Anchors.assign(mesh.points.begin(), mesh.points.begin() + static_cast<std::ptrdiff_t>(numberOfCorners));
    this->LiftCenters(mesh);
    return mesh;
  }

  void
  FitStar(WallMesh & mesh) const
  {
    for (int round = 0; round < StarRounds; ++round)
    {
      this->VolumeStep(mesh);
    }
  }

  void
  FitRemeshed(WallMesh & mesh, double trianglesPerCell, WallFittingStatistics & statistics)
  {
    // The mesh is remeshed three times, as its lines and walls grow longer on their way to the image. The rounds after
    // each remeshing project the points, improve the triangles and give the cells their volumes, and take back what
    // makes triangles cross.
    const double wanted = trianglesPerCell * static_cast<double>(m_Junctions.cells.size() - 1);
    double       done = 0.0;
    const double all = LastVolumeSteps + std::accumulate(std::begin(RoundsPerMeshing), std::end(RoundsPerMeshing), 0.0);
    m_Execution.Report(StarShare);
    std::vector<double> lengths = this->RemeshStar(mesh, wanted, statistics);
    double              area = ComputeArea(mesh);
    WallProjection      projection(mesh, m_Volume, m_Field, m_Faces, lengths, m_Anchors);
    for (std::size_t meshing = 0; meshing < std::size(RoundsPerMeshing); ++meshing)
    {
      if (meshing > 0)
      {
        this->RemeshAgain(mesh, wanted, lengths, area);
        projection.SetWalls(mesh, lengths);
      }
      for (int round = 0; round < RoundsPerMeshing[meshing]; ++round)
      {
        const std::vector<Point> before = mesh.points;
        projection.Move(mesh, m_Execution);
        ImproveTriangles(mesh, 1, m_Execution);
        FitVolumes(mesh, m_Volumes, VolumeShare);
        StepBackFromCrossings(mesh, before, GuardShares, m_Execution);
        done += 1.0;
        m_Execution.Report(StarShare + (1.0 - StarShare) * done / all);
      }
    }
    for (int step = 0; step < LastVolumeSteps && !this->HasItsVolumes(mesh); ++step)
    {
      this->VolumeStep(mesh);
      done += 1.0;
      m_Execution.Report(StarShare + (1.0 - StarShare) * done / all);
    }
  }

  /** Numbers the corners as Dualize() does, in the order of the tetrahedra. */
  void
  PutCornersInOrder(WallMesh & mesh) const
  {
    std::vector<PointId> order(mesh.points.size());
    std::iota(order.begin(), order.end(), PointId{ 0 });
    std::copy(m_CornerOfTetrahedron.begin(), m_CornerOfTetrahedron.end(), order.begin());
    TakePoints(mesh, order);
  }

private:
  void
  OrderSpatially(WallMesh & mesh, std::size_t numberOfCorners)
  {
    mesh = OrderWalls(mesh, m_Ranks);
    const std::vector<PointId> order = PointsByTriangles(mesh);
    TakePoints(mesh, order);
    m_CornerOfTetrahedron.resize(numberOfCorners);
    for (std::size_t i = 0; i < numberOfCorners; ++i)
    {
      m_CornerOfTetrahedron[order[i]] = static_cast<PointId>(i);
    }
  }

  void
  CountUnfitted(const AdjacencyComplex & complex, const std::vector<std::size_t> & corners,
                WallFittingStatistics & statistics) const
  {
    const std::vector<VertexQuadruple> tetrahedra = complex.GetTetrahedra();
    statistics.unfittedCorners = static_cast<std::int64_t>(corners.size());
    statistics.unfittedCornersOfCell.assign(m_Volumes.size(), 0);
    for (const std::size_t corner : corners)
    {
      for (const VertexId v : tetrahedra[corner])
      {
        ++statistics.unfittedCornersOfCell[v];
      }
    }
  }

  /** Each wall's centre goes towards the centroid of the image's wall, as far as nothing crosses. */
  void
  LiftCenters(WallMesh & mesh) const
  {
    const std::vector<Point> before = mesh.points;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      const PointId center = mesh.triangles[t][0];
      if (mesh.numberOfCells[center] != CellsWithinWall)
      {
        continue; // It has none.
      }
      if (const Wall * const wall = FindWall(m_Junctions, mesh.walls[mesh.wallOfTriangle[t]].cells))
      {
        mesh.points[center] = wall->center;
      }
    }
    StepBackFromCrossings(mesh, before, LiftShares, m_Execution);
  }

  void
  VolumeStep(WallMesh & mesh) const
  {
    const std::vector<Point> before = mesh.points;
    FitVolumes(mesh, m_Volumes, VolumeShare);
    StepBackFromCrossings(mesh, before, GuardShares, m_Execution);
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

  std::vector<double>
  RemeshStar(WallMesh & mesh, double wanted, WallFittingStatistics & statistics) const
  {
    const std::vector<double> factors = EdgeLengthFactorsByCell(mesh, m_Volumes, SizeExponent);
    WallMesh                  star = mesh;
    const std::vector<double> lengths = RemeshToNumberOfTriangles(mesh, wanted, factors, m_Execution);
    SubdivideLines(star, lengths);
    SubdivideWalls(star, lengths, m_Execution);
    statistics.starWalls = MendCrossingWalls(mesh, star, m_Execution);
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
    MendCrossingWalls(mesh, old, m_Execution);
  }

  const JunctionSet & m_Junctions;
  const LabelVolume & m_Volume;
  /** Of the vertices, in spatial order. */
  const std::vector<VertexId> & m_Ranks;
  IndicatorField                m_Field;
  const Execution &             m_Execution;
  std::vector<double>           m_Volumes;
  ImagePlaces                   m_Faces{ 0, {} };
  /** Where the corners are fitted and apart. */
  std::vector<Point> m_Anchors;
  /** The mesh's own corners are in spatial order. */
  std::vector<PointId> m_CornerOfTetrahedron;
};
} // namespace

WallMesh
FitWalls(const AdjacencyComplex & complex, const JunctionSet & junctions, const LabelVolume & volume,
         const std::vector<VertexId> & ranks, double trianglesPerCell, WallFittingStatistics * statistics,
         const Execution & execution)
{
  WallFittingStatistics   own;
  WallFittingStatistics & s = statistics != nullptr ? *statistics : own;
  Fitter                  fitter(junctions, volume, ranks, execution);
  WallMesh                mesh = fitter.MakeStar(complex, s);
  if (trianglesPerCell > 0.0)
  {
    fitter.FitRemeshed(mesh, trianglesPerCell, s);
  }
  else
  {
    fitter.FitStar(mesh);
  }
  fitter.PutCornersInOrder(mesh);
  s.crossingPairs = static_cast<std::int64_t>(FindCrossings(mesh, execution).size());
  return mesh;
}
} // namespace tissue
