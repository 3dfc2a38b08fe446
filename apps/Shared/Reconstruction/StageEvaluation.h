/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef StageEvaluation_h
#define StageEvaluation_h

#include "Shared/Reconstruction/TissueInput.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

namespace tissue
{
/** The label image that a tissue from other sources is judged by, beside that tissue's cells. */
struct Judge
{
  JunctionSet junctions;
  /** Of each vertex of the tissue the cell of the judge that its centre is in, negative where there is none or another
   * vertex has it; the exterior is the exterior. */
  std::vector<VertexId> cellOfVertex;
  /** Cells of the tissue, and of the judge, that have no counterpart. */
  std::size_t numberOfUnknownCells = 0;
  std::size_t numberOfMissedCells = 0;
};

/** Reads the label image.
 * \param isByLabel whether cells of the same label are the same cell, wherever their centres are.
 * \throws std::runtime_error as ReadTissue(), with the file's name. */
Judge
ReadJudge(const std::string & path, const std::vector<Cell> & cells, bool isByLabel, ProgressBar & progress);

struct StageEvaluation
{
  AdjacencyOverlap delaunay;
  AdjacencyOverlap cleaned;
  AdjacencyOverlap optimized;
};

/** The stages must be kept (ReconstructionParameters::keepStages). */
StageEvaluation
EvaluateStages(const TissueReconstruction & reconstruction, const Judge & judge);
} // namespace tissue

#endif
