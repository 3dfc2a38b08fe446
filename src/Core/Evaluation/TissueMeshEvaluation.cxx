/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Evaluation/TissueMeshEvaluation.h"

#include "TissueTessellationCore/Evaluation/VoxelDice.h"

#include <numeric>
#include <stdexcept>

namespace tissue
{
TissueMeshEvaluation
EvaluateTissueMesh(const WallMesh & walls, const JunctionSet & junctions, const LabelVolume & labels,
                   const ParallelFor & parallelFor)
{
  if (junctions.cells.size() < 2)
  {
    throw std::invalid_argument("the image has no cell to judge a mesh by");
  }
  const auto           numberOfVertices = static_cast<VertexId>(junctions.cells.size());
  TissueMeshEvaluation evaluation;
  evaluation.mesh = EvaluateWallMesh(walls, junctions, parallelFor);
  evaluation.distance = MeasureWallDistance(walls, numberOfVertices, labels, parallelFor);
  evaluation.dice = ComputeVoxelDice(walls, numberOfVertices, labels, parallelFor);
  evaluation.meanDice = std::accumulate(evaluation.dice.begin() + 1, evaluation.dice.end(), 0.0) /
                        static_cast<double>(evaluation.mesh.numberOfCells);
  return evaluation;
}
} // namespace tissue
