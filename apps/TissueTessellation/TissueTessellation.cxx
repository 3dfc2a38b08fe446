/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// From a segmented 3-D image of a tissue, or one of its membranes, to the triangular mesh of all its cell walls.
#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Reconstruction/ReconstructionRun.h"
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
  const JunctionOptions junctionOptions{ options.image.exterior, needsVolume, options.image.acceptsSpecks, {} };
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
    if (const auto options = ParseCommandLine(argc, argv))
    {
      RunReconstruction(
        program, *options, [&options](ProgressBar & progress) { return ReadInput(*options, progress); });
    }
  });
}
