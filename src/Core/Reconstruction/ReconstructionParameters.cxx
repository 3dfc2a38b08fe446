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
ReconstructionParameters::ReconstructionParameters()
{
  // The image tells the neighbours: the terms without it only pull away from what it shows.
  energy.neighborWeight = 0.0;
  energy.lengthWeight = 0.0;
  annealing.legality = Legality::Combinatorial;
  annealing.ringRule = RingRule::BestOfReference;
  annealing.maximumDegree = 12;
}

ReconstructionParameters
ReconstructionParameters::PointsPreset()
{
  ReconstructionParameters parameters;
  parameters.source = ComplexSource::Centers;
  parameters.energy.neighborWeight = 0.02;
  parameters.energy.delaunayWeight = 30.0;
  return parameters;
}

ReconstructionParameters
ReconstructionParameters::PaperPreset()
{
  ReconstructionParameters parameters;
  parameters.source = ComplexSource::Centers;
  parameters.maximumEdgeLengthFactor = 1.4;
  parameters.energy = EnergyParameters();
  parameters.annealing = AnnealingParameters();
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
