/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ReconstructionRun_h
#define ReconstructionRun_h

#include "Shared/CommandLine/RunOptions.h"
#include "Shared/Projection/Projection.h"
#include "Shared/Reconstruction/ReconstructionOutput.h"

namespace tissue
{
/** \brief What a program does from its options to its outputs: what cannot be written, or projected, is refused before
 * the work.
 *
 * \param readInput called with the progress bar; returns the cells, a TissueInput. */
template <typename TOptions, typename TReadInput>
void
RunReconstruction(const std::string & program, const TOptions & options, const TReadInput & readInput)
{
  RequireOutputs(options.outputs, options.InputFiles());
  UseThreads(options.run.threads);
  ProgressBar progress(options.run.GetProgressStyle());

  ProjectionSources sources = ReadProjectionSources(options.projection, progress);
  RequireColumn(options.outputs, sources.ColumnNames());
  TissueInput               input = readInput(progress);
  Projection                projection(std::move(sources),
                        options.projection.wallDistance,
                        input.GetJunctionSet().cells,
                        input.names,
                        input.extracted.volume,
                        input.image.unit);
  const ReconstructedTissue tissue =
    Reconstruct(input, std::move(input.extracted.volume), options.method.parameters, progress);
  const auto evaluation = EvaluateStages(options.evaluation, input, tissue.mesh->GetReconstruction(), progress);
  const ProjectedData        projected = projection.Project(tissue.mesh, progress);
  const ReconstructionReport report{ program, ToJson(options), input, tissue, evaluation, projection, projected };
  WriteOutputs(options.outputs, report, progress);
  Say(report, options.outputs, options.run.isQuiet);
  RequireNoFaults(report, options.run.isStrict);
}
} // namespace tissue

#endif
