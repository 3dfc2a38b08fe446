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
#include "TissueTessellationCore/Evaluation/ExteriorTopology.h"
#include "TissueTessellationCore/Evaluation/SeparateWalls.h"
#include "TissueTessellationCore/Evaluation/WallDistance.h"
#include "TissueTessellationCore/Geometry/TriangleQuality.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallAngles.h"

namespace tissue
{
/** \brief How well a wall mesh keeps the cells of a label image and their adjacencies, by its triangles alone. */
struct WallMeshEvaluation
{
  std::size_t numberOfTriangles = 0;
  /** The number of cells of the image, the exterior not counted. */
  std::size_t numberOfCells = 0;
  std::size_t numberOfMissingCells = 0;
  /** The number of cells whose surface is closed, of those whose surface consists of spheres, and of those whose
   * surface is one sphere (CellSurface). */
  std::size_t numberOfClosedCells = 0;
  std::size_t numberOfCellsOfSpheres = 0;
  std::size_t numberOfSpheres = 0;
  /** The number of points where four or more cells meet, the exterior counted. */
  std::size_t numberOfCorners = 0;
  /** The number of corners where more than four cells meet. */
  std::size_t numberOfCrowdedCorners = 0;
  /** The mean of |V - V_image| / V_image over the closed cells, in 0 .. 1 as a rule; -1 where no cell is closed. */
  double meanVolumeError = -1.0;
  /** The volume error that a twentieth of the closed cells exceed; -1 where no cell is closed. */
  double volumeErrorPercentile95 = -1.0;
  /** The share of all cells that are closed and within one percent of their volume in the image. */
  double shareWithinOnePercent = 0.0;
  /** The mean over the closed cells of their volume over that of their convex hull, in 0 .. 1; -1 where no cell is
   * closed. */
  double meanConvexity = -1.0;
  /** The overlap with the image's adjacencies of the pairs of cells with a triangle between them, and of the quadruples
   * of cells around a point. A point where more than four cells meet stands for each four of them, as a block of voxels
   * of the image does; those of them that are no neighbours do not count in adjacency4OfNeighbors, so that a mesh of
   * the image's voxel faces has 1 in all three. */
  AdjacencyOverlap overlap;
  QualitySummary   quality;
  /** The least angles, and the edges; angles in degrees. */
  WallAngles  angles;
  std::size_t numberOfDegenerateTriangles = 0;
  /** The number of pairs of triangles that cross (TriangleCrossing.h). */
  std::size_t numberOfCrossings = 0;

  struct Cell
  {
    /** Volume error and convexity are -1 where the cell is not closed. */
    double       volumeError = -1.0;
    double       convexity = -1.0;
    std::int32_t eulerCharacteristic = 0;
    /** The number of pieces of the surface. */
    std::int32_t numberOfPieces = 0;
    bool         isClosed = false;
    /** Whether every piece is a sphere, and whether there is but one. */
    bool hasOnlySpheres = false;
    bool isSphere = false;
  };
  /** What was found of each cell, by vertex. The entry of the exterior stays empty. */
  std::vector<Cell> cells;
};

/** \brief Judges a mesh of any origin by the junctions of the image it was made from.
 *
 * `walls` has vertices of the set's cells, and may have one more vertex, cells.size(), that stands for gaps between
 * cells. That one is not a cell, and in no pair or quadruple. Volumes should be in the image's units.
 * \throws std::invalid_argument as RequireConsistentIndices does. */
WallMeshEvaluation
EvaluateWallMesh(const WallMesh & walls, const JunctionSet & junctions, const Execution & execution = Execution());

/** \brief All that is found of a wall mesh by the label image it was made from: of its cells and triangles, of its
 * walls' number and distance to those of the image, of the tissue's surface, and of its voxels. */
struct TissueMeshEvaluation
{
  WallMeshEvaluation mesh;
  WallDistance       distance;
  SeparateWalls      separateWalls;
  /** The boundary of the exterior in the image and in the mesh. */
  SurfaceTopology exteriorOfImage;
  SurfaceTopology exteriorOfMesh;
  /** The Dice index of the voxels of each vertex (VoxelDice.h), and its mean over the cells. */
  std::vector<double> dice;
  double              meanDice = 0.0;

  double
  TrianglesPerCell() const
  {
    return static_cast<double>(mesh.numberOfTriangles) / static_cast<double>(mesh.numberOfCells);
  }
};

/** Judges a mesh of any origin by EvaluateWallMesh, MeasureWallDistance, CountSeparateWalls, FindExteriorTopology and
 * ComputeVoxelDice. The result is the same
 * for any number of threads. \throws std::invalid_argument as RequireConsistentIndices does, and where there is no
 * cell. */
TissueMeshEvaluation
EvaluateTissueMesh(const WallMesh & walls, const JunctionSet & junctions, const LabelVolume & labels,
                   const Execution & execution = Execution());
} // namespace tissue

#endif
