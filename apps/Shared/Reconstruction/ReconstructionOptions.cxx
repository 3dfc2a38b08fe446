/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ReconstructionOptions.h"

#include <algorithm>

namespace tissue
{
std::vector<ReconstructionOptions::Output>
ReconstructionOptions::Outputs() const
{
  std::vector<Output> outputs{ { walls, "cell walls" },    { complex, "adjacency complex" },
                               { cells, "cells" },         { statistics, "statistics of the cells" },
                               { junctions, "junctions" }, { report, "report" },
                               { picture, "picture" } };
  const auto          isUnasked = [](const Output & output) { return output.path.empty(); };
  outputs.erase(std::remove_if(outputs.begin(), outputs.end(), isUnasked), outputs.end());
  return outputs;
}

std::vector<std::string>
ReconstructionOptions::Inputs() const
{
  std::vector<std::string> inputs{ labels, membrane.file, evaluateAgainst };
  inputs.insert(inputs.end(), otherInputs.begin(), otherInputs.end());
  inputs.erase(std::remove(inputs.begin(), inputs.end(), std::string()), inputs.end());
  return inputs;
}
} // namespace tissue
