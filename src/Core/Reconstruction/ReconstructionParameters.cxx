/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/ReconstructionParameters.h"

#include "TissueTessellationCore/Reconstruction/ParameterTable.h"

#include <stdexcept>

namespace tissue
{
ReconstructionParameters
ReconstructionParameters::PaperPreset()
{
  ReconstructionParameters parameters;
  parameters.source = ComplexSource::Centers;
  parameters.corners = CornerRule::ProjectedCircumcenter;
  parameters.fitToImage = false;
  return parameters;
}

ReconstructionParameters
ReconstructionParameters::PaperPointsPreset()
{
  ReconstructionParameters parameters = PaperPreset();
  parameters.energy.adjacencyWeight = 0.0;
  parameters.energy.unitLength = 0.0;
  parameters.energy.lengthWeight = 15.0;
  parameters.energy.delaunayWeight = 300.0;
  parameters.annealing.initialTemperature = 0.03;
  parameters.localMaximumEdgeLength = true;
  parameters.maximumEdgeLengthFactor = 1.5;
  parameters.corners = CornerRule::LiftedCircumcenter;
  return parameters;
}

void
ReconstructionParameters::Check() const
{
  for (const Parameter & parameter : GetParameterTable())
  {
    const std::string fault = FindFault(parameter, *this);
    if (!fault.empty())
    {
      throw std::invalid_argument(parameter.name + ' ' + fault);
    }
  }
}
} // namespace tissue
