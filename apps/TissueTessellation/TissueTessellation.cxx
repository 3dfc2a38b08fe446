/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// From a segmented 3-D image of a tissue, or one of its membranes, to the triangular mesh of all its cell walls.
#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Reconstruction/ReconstructionOutput.h"
#include "TissueTessellation/TissueTessellationOptions.h"

namespace
{
using namespace tissue;

TissueInput
ReadInput(const TissueTessellationOptions & options, ProgressBar & progress)
{
  const ReconstructionParameters & parameters = options.method.parameters;
  const bool                       needsVolume =
    parameters.fitToImage || parameters.source == ComplexSource::Image || !options.projection.signals.empty();
  const JunctionOptions junctionOptions{ options.image.exterior, needsVolume, options.image.acceptsSpecks };
  return options.membrane.file.empty()
           ? ExtractTissue(ReadLabelImage(options.image, progress), junctionOptions, progress)
           : ReadMembranes(options.membrane, junctionOptions, progress);
}
} // namespace

int
main(int argc, char ** argv)
{
  const std::string program = "TissueTessellation";
  return RunProgram(program, [&] {
    const auto options = ParseCommandLine(argc, argv);
    if (!options)
    {
      return;
    }
    RequireOutputs(options->outputs, options->InputFiles());
    UseThreads(options->run.threads);
    ProgressBar progress(options->run.GetProgressStyle());

    ProjectionSources sources = ReadProjectionSources(options->projection, progress);
    RequireColumn(options->outputs, sources.ColumnNames());
    TissueInput               input = ReadInput(*options, progress);
    Projection                projection(std::move(sources),
                          options->projection.wallDistance,
                          input.GetJunctionSet().cells,
                          input.names,
                          input.extracted.volume,
                          input.image.unit);
    const ReconstructedTissue tissue =
      Reconstruct(input, std::move(input.extracted.volume), options->method.parameters, progress);
    const auto evaluation = EvaluateStages(options->evaluation, input, tissue.mesh->GetReconstruction(), progress);
    const ProjectedData        projected = projection.Project(tissue.mesh, progress);
    const ReconstructionReport report{ program, ToJson(*options), input, tissue, evaluation, projection, projected };
    WriteOutputs(options->outputs, report, progress);
    Say(report, options->outputs, options->run.isQuiet);
    RequireNoFaults(report, options->run.isStrict);
  });
}
