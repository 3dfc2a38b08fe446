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
#include "Shared/Reconstruction/ReconstructionRun.h"

int
main(int argc, char ** argv)
{
  using namespace tissue;
  const std::string program = "NucleiTessellation";
  return RunProgram(program, [&] {
    if (const auto options = ParseCommandLine(argc, argv))
    {
      RunReconstruction(
        program, *options, [&options](ProgressBar & progress) { return ReadPointTissue(*options, progress); });
    }
  });
}
