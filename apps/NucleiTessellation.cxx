/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// From the centres of a tissue's cells or nuclei to the triangular mesh of all its cell walls.
#include "NucleiTessellationOptions.h"
#include "PointInput.h"
#include "RunProgram.h"
#include "TissueProgram.h"

int
main(int argc, char ** argv)
{
  using namespace tissue;
  const std::string program = "NucleiTessellation";
  return RunProgram(program, [&] {
    if (const auto options = ParseNucleiCommandLine(argc, argv))
    {
      RunTissueProgram(program, *options, ToJson(*options), [&](ProgressBar & progress) {
        return ReadPointTissue(*options, progress);
      });
    }
  });
}
