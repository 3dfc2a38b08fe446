/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallMeshEvaluation_h
#define TissueTessellationCore_WallMeshEvaluation_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "TissueTessellationCore/Evaluation/WallDistance.h"
#include "TissueTessellationCore/Geometry/TriangleQuality.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief How well a wall mesh keeps the cells of a label image and their adjacencies, by its triangles alone. */
struct WallMeshEvaluation
{
  std::size_t numberOfTriangles = 0;
  /** Cells of the image, the exterior not counted. */
  std::size_t numberOfCells = 0;
  std::size_t numberOfMissingCells = 0;
  /** Cells whose surface is closed, and those of them where it is one sphere; CellSurface says which these are. */
  std::size_t numberOfClosedCells = 0;
  std::size_t numberOfSpheres = 0;
  /** Points where four or more cells meet, the exterior counted. */
  std::size_t numberOfCorners = 0;
  /** Corners where more than four meet. */
  std::size_t numberOfCrowdedCorners = 0;
  /** Mean of |V - V_image| / V_image over the closed cells, in 0 .. 1 as a rule; -1 where no cell is closed. */
  double meanVolumeError = -1.0;
  /** A twentieth of the closed cells have a larger one; -1 likewise. */
  double volumeErrorPercentile95 = -1.0;
  /** Share of all cells that are closed and within one percent of their volume in the image. */
  double shareWithinOnePercent = 0.0;
  /** Mean over the closed cells of the volume over that of the convex hull, in 0 .. 1; -1 likewise. */
  double meanConvexity = -1.0;
  /** Pairs of cells with a triangle between them, and quadruples of cells around a point, against those of the image.
   * A point where more than four cells meet stands for each four of them, as a block of voxels of the image does. */
  AdjacencyOverlap overlap;
  QualitySummary   quality;
  std::size_t      numberOfDegenerateTriangles = 0;
  /** Pairs of triangles that cross (TriangleCrossing.h). */
  std::size_t numberOfCrossings = 0;

  struct Cell
  {
    /** -1 where the cell is not closed. */
    double       volumeError = -1.0;
    double       convexity = -1.0;
    std::int32_t eulerCharacteristic = 0;
    bool         isClosed = false;
    bool         isSphere = false;
  };
  /** By vertex; that of the exterior is empty. */
  std::vector<Cell> cells;
};

/** \brief Judges a mesh of any origin by the junctions of the image it was made from.
 *
 * `walls` has vertices of the set's cells, and may have one more vertex, cells.size(), that stands for gaps between
 * cells: it is no cell, and in no pair or quadruple. Volumes are meant to be in the image's units.
 * \throws std::invalid_argument as RequireConsistentIndices does. */
WallMeshEvaluation
EvaluateWallMesh(const WallMesh & walls, const JunctionSet & junctions, const Execution & execution = Execution());

/** \brief All that is found of a wall mesh by the label image that it is of: its cells and triangles, its walls'
 * distance to those of the image, its voxels. */
struct TissueMeshEvaluation
{
  WallMeshEvaluation mesh;
  WallDistance       distance;
  /** Dice index of the voxels of each vertex (VoxelDice.h), and its mean over the cells. */
  std::vector<double> dice;
  double              meanDice = 0.0;

  double
  TrianglesPerCell() const
  {
    return static_cast<double>(mesh.numberOfTriangles) / static_cast<double>(mesh.numberOfCells);
  }
};

/** Judges a mesh of any origin; as EvaluateWallMesh, MeasureWallDistance and ComputeVoxelDice do. The same for any
 * number of threads. \throws std::invalid_argument as RequireConsistentIndices does, and where there is no cell. */
TissueMeshEvaluation
EvaluateTissueMesh(const WallMesh & walls, const JunctionSet & junctions, const LabelVolume & labels,
                   const Execution & execution = Execution());
} // namespace tissue

#endif
