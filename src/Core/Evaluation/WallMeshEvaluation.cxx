/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Evaluation/WallMeshEvaluation.h"

#include "Adjacency/ReferenceAdjacency.h"
#include "Common/Algorithms.h"
#include "Evaluation/VoxelDice.h"
#include "Geometry/ConvexHull.h"
#include "Mesh/Crossings.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tissue
{
namespace
{
/** A point, and a cell that has a triangle at it. */
using Incidence = std::pair<PointId, VertexId>;

/** Lists all incidences, each once, ordered by points, then by cells. */
std::vector<Incidence>
CollectIncidences(const WallMesh & walls, VertexId numberOfVertices)
{
  std::vector<Incidence> incidences;
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    for (const VertexId cell : walls.walls[walls.wallOfTriangle[t]].cells)
    {
      if (cell < numberOfVertices)
      {
        for (const PointId p : walls.triangles[t])
        {
          incidences.emplace_back(p, cell);
        }
      }
    }
  }
  SortUnique(incidences);
  return incidences;
}

/** Appends each four of the cells, which must be in ascending order. */
void
AppendQuadruples(const std::vector<VertexId> & cells, std::vector<VertexQuadruple> & quadruples)
{
  const std::size_t n = cells.size();
  for (std::size_t a = 0; a < n; ++a)
  {
    for (std::size_t b = a + 1; b < n; ++b)
    {
      for (std::size_t c = b + 1; c < n; ++c)
      {
        for (std::size_t d = c + 1; d < n; ++d)
        {
          quadruples.push_back({ { cells[a], cells[b], cells[c], cells[d] } });
        }
      }
    }
  }
}

/** Counts the corners, and returns the quadruples at them, each once. */
std::vector<VertexQuadruple>
CollectQuadruples(const WallMesh & walls, VertexId numberOfVertices, WallMeshEvaluation & evaluation)
{
  const std::vector<Incidence> incidences = CollectIncidences(walls, numberOfVertices);
  std::vector<VertexQuadruple> quadruples;
  std::vector<VertexId>        cells;
  for (auto first = incidences.begin(); first != incidences.end();)
  {
    cells.clear();
    const PointId point = first->first;
    for (; first != incidences.end() && first->first == point; ++first)
    {
      cells.push_back(first->second);
    }
    evaluation.numberOfCorners += cells.size() >= CellsAtCorner ? 1 : 0;
    evaluation.numberOfCrowdedCorners += cells.size() > CellsAtCorner ? 1 : 0;
    AppendQuadruples(cells, quadruples);
  }
  SortUnique(quadruples);
  return quadruples;
}

std::vector<VertexPair>
CollectPairs(const WallMesh & walls, VertexId numberOfVertices)
{
  std::vector<VertexPair> pairs;
  for (const WallId wall : walls.wallOfTriangle)
  {
    VertexPair cells = walls.walls[wall].cells;
    std::sort(cells.begin(), cells.end());
    if (cells[1] < numberOfVertices)
    {
      pairs.push_back(cells);
    }
  }
  SortUnique(pairs);
  return pairs;
}

/** Lists the points of the triangles of each cell, each once and in ascending order, as exact predicates are slow where
 * points are equal. */
std::vector<std::vector<Point>>
PointsOfCells(const WallMesh & walls, VertexId numberOfVertices)
{
  std::vector<std::vector<Point>> points(static_cast<std::size_t>(numberOfVertices));
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    for (const VertexId cell : walls.walls[walls.wallOfTriangle[t]].cells)
    {
      if (cell != ExteriorVertex && cell < numberOfVertices)
      {
        for (const PointId p : walls.triangles[t])
        {
          points[cell].push_back(walls.points[p]);
        }
      }
    }
  }
  std::for_each(points.begin(), points.end(), SortUnique<Point>);
  return points;
}

/** Judges the surface of each cell: its topology, its volume against the image's, and its volume against that of its
 * convex hull. */
void
JudgeCells(const WallMesh & walls, const std::vector<Cell> & cells, const Execution & execution,
           WallMeshEvaluation & evaluation)
{
  const auto             numberOfVertices = static_cast<VertexId>(cells.size());
  const CellSurfaceCheck check = CheckCellSurfaces(walls, numberOfVertices + 1);
  const auto             points = PointsOfCells(walls, numberOfVertices);
  evaluation.numberOfDegenerateTriangles = static_cast<std::size_t>(check.numberOfDegenerateTriangles);
  evaluation.angles = check.angles;
  evaluation.angles.minimumDihedralOfCell.resize(cells.size()); // without that of gaps
  evaluation.angles.minimumDihedralAngle =
    *std::min_element(evaluation.angles.minimumDihedralOfCell.begin(), evaluation.angles.minimumDihedralOfCell.end());
  evaluation.cells.resize(cells.size());
  execution.For(cells.size() - 1, [&](std::size_t i) {
    const std::size_t          v = i + 1;
    const CellSurface &        surface = check.cells[v];
    WallMeshEvaluation::Cell & cell = evaluation.cells[v];
    cell.eulerCharacteristic = surface.eulerCharacteristic;
    cell.isClosed = surface.IsClosed();
    cell.numberOfPieces = surface.numberOfComponents;
    cell.hasOnlySpheres = surface.HasOnlySpheres();
    cell.isSphere = surface.IsSphere();
    if (cell.isClosed)
    {
      cell.volumeError = std::abs(surface.volume - cells[v].volume) / cells[v].volume;
      const double hull = ConvexHullVolume(points[v]);
      cell.convexity = hull > 0.0 ? std::clamp(surface.volume / hull, 0.0, 1.0) : 0.0;
    }
  });
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    evaluation.numberOfMissingCells += check.cells[v].numberOfTriangles == 0 ? 1 : 0;
  }
}

/** Sums up what was found of the cells: counts over all of them, means and a percentile over those that are closed. */
void
SumUpCells(WallMeshEvaluation & evaluation)
{
  std::vector<double> errors;
  double              convexity = 0.0;
  std::size_t         withinOnePercent = 0;
  for (const WallMeshEvaluation::Cell & cell : evaluation.cells)
  {
    evaluation.numberOfCellsOfSpheres += cell.hasOnlySpheres ? 1 : 0;
    evaluation.numberOfSpheres += cell.isSphere ? 1 : 0;
    if (cell.isClosed)
    {
      errors.push_back(cell.volumeError);
      withinOnePercent += cell.volumeError <= 0.01 ? 1 : 0;
      convexity += cell.convexity;
    }
  }
  evaluation.numberOfClosedCells = errors.size();
  if (!errors.empty())
  {
    const auto n = static_cast<double>(errors.size());
    std::sort(errors.begin(), errors.end());
    evaluation.meanVolumeError = std::accumulate(errors.begin(), errors.end(), 0.0) / n;
    evaluation.volumeErrorPercentile95 = errors[static_cast<std::size_t>(0.95 * (n - 1.0))];
    evaluation.shareWithinOnePercent =
      static_cast<double>(withinOnePercent) / static_cast<double>(evaluation.numberOfCells);
    evaluation.meanConvexity = convexity / n;
  }
}
} // namespace

WallMeshEvaluation
EvaluateWallMesh(const WallMesh & walls, const JunctionSet & junctions, const Execution & execution)
{
  const auto         numberOfVertices = static_cast<VertexId>(junctions.cells.size());
  WallMeshEvaluation evaluation;
  evaluation.numberOfTriangles = walls.triangles.size();
  evaluation.numberOfCells = junctions.cells.size() - 1;
  JudgeCells(walls, junctions.cells, execution, evaluation);
  SumUpCells(evaluation);
  const AdjacencyTuples tuples{ CollectPairs(walls, numberOfVertices),
                                CollectQuadruples(walls, numberOfVertices, evaluation) };
  evaluation.overlap = ComputeAdjacencyOverlap(tuples, ReferenceAdjacency(junctions));
  evaluation.quality = SummarizeTriangleQuality(walls.points, walls.triangles);
  evaluation.numberOfCrossings = FindCrossings(walls, execution).size();
  return evaluation;
}

TissueMeshEvaluation
EvaluateTissueMesh(const WallMesh & walls, const JunctionSet & junctions, const LabelVolume & labels,
                   const Execution & execution)
{
  if (junctions.cells.size() < 2)
  {
    throw std::invalid_argument("the image has no cell to judge a mesh by");
  }
  const auto           numberOfVertices = static_cast<VertexId>(junctions.cells.size());
  TissueMeshEvaluation evaluation;
  evaluation.mesh = EvaluateWallMesh(walls, junctions, execution);
  evaluation.distance = MeasureWallDistance(walls, numberOfVertices, labels, execution);
  evaluation.separateWalls = CountSeparateWalls(walls, labels, execution);
  evaluation.exteriorOfImage = FindExteriorTopology(labels, execution);
  evaluation.exteriorOfMesh = FindExteriorTopology(walls);
  evaluation.dice = ComputeVoxelDice(walls, numberOfVertices, labels, execution);
  evaluation.meanDice = std::accumulate(evaluation.dice.begin() + 1, evaluation.dice.end(), 0.0) /
                        static_cast<double>(evaluation.mesh.numberOfCells);
  return evaluation;
}
} // namespace tissue
