/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueMeshEvaluation_h
#define TissueTessellationCore_TissueMeshEvaluation_h

#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Evaluation/WallDistance.h"
#include "TissueTessellationCore/Evaluation/WallMeshEvaluation.h"

namespace tissue
{
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
                   const ParallelFor & parallelFor = ParallelFor());
} // namespace tissue

#endif
