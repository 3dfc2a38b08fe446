/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// From a segmented 3-D image of a tissue, or one of its membranes, to the triangular mesh of all its cell walls.
#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Reconstruction/MembraneInput.h"
#include "Shared/Reconstruction/ReconstructionProgram.h"
#include "Shared/Reconstruction/TissueInput.h"
#include "TissueTessellation/TissueTessellationOptions.h"

int
main(int argc, char ** argv)
{
  using namespace tissue;
  const std::string program = "TissueTessellation";
  return RunProgram(program, [&] {
    if (const auto options = ParseCommandLine(argc, argv))
    {
      RunTissueProgram(program, *options, ToJson(*options), [&](ProgressBar & progress) {
        return options->membrane.file.empty() ? ReadTissue(*options, progress) : ReadMembranes(*options, progress);
      });
    }
  });
}
