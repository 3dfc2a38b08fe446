/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// From the centres of a tissue's cells or nuclei to the triangular mesh of all its cell walls.
#include "NucleiTessellation/NucleiTessellationOptions.h"
#include "NucleiTessellation/PointTissueInput.h"
#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Reconstruction/ReconstructionOutput.h"

int
main(int argc, char ** argv)
{
  using namespace tissue;
  const std::string program = "NucleiTessellation";
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
    TissueInput               input = ReadPointTissue(*options, progress);
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
