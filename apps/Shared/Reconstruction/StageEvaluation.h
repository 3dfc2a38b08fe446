/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef StageEvaluation_h
#define StageEvaluation_h

#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Images/ImageOptions.h"
#include "Shared/Reconstruction/TissueInput.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

#include <CLI/CLI.hpp>

namespace tissue
{
/** How the stages of the complex are judged. */
struct EvaluationOptions
{
  /** The label image that judges; empty: none. */
  std::string  against;
  ImageOptions image;
  /** Whether cells of the same label are the same cell, wherever their centres are. */
  bool byLabel = false;
};

void
AddEvaluationOptions(CLI::App & app, EvaluationOptions & options);

/** The agreement of the stages with the label image that judges. */
struct StageEvaluation
{
  std::string against;
  /** Cells of the tissue, and of the judge, that have no counterpart. */
  std::size_t numberOfUnknownCells = 0;
  std::size_t numberOfMissedCells = 0;
  /** What is to be said of the image that judges. */
  std::vector<std::string> warnings;
  /** In the order of the reconstruction's stages. */
  std::vector<AdjacencyOverlap> stages;
};

/** Nothing unless a label image is to judge. The stages must be kept (ReconstructionParameters::keepStages).
 * \throws FileError as ReadLabelImage() and ExtractTissue(). */
std::optional<StageEvaluation>
EvaluateStages(const EvaluationOptions & options, const TissueInput & input,
               const TissueReconstruction & reconstruction, ProgressBar & progress);
} // namespace tissue

#endif
