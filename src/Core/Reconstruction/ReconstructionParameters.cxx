/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/ReconstructionParameters.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
void
CheckRange(const char * name, double value, double least, double most)
{
  if (!(value >= least && value <= most))
  {
    std::ostringstream message;
    message << name << " is " << value << ", must be in " << least << " .. " << most;
    throw std::invalid_argument(message.str());
  }
}
} // namespace

ReconstructionParameters::ReconstructionParameters()
{
  // The image tells the neighbours: the terms without it only pull away from what it shows.
  energy.pairWeight = 0.8;
  energy.neighborWeight = 0.0;
  energy.lengthWeight = 0.0;
  annealing.legality = Legality::Combinatorial;
  annealing.ringRule = RingRule::BestOfReference;
  annealing.maximumDegree = 12;
  annealing.isFocused = true;
}

ReconstructionParameters
ReconstructionParameters::PointsPreset()
{
  ReconstructionParameters parameters;
  parameters.energy.neighborWeight = 0.02;
  parameters.energy.delaunayWeight = 30.0;
  return parameters;
}

ReconstructionParameters
ReconstructionParameters::PaperPreset()
{
  ReconstructionParameters parameters;
  parameters.separateParts = false;
  parameters.separateVoids = false;
  parameters.maximumEdgeLengthFactor = 1.4;
  parameters.guidedCleanUp = false;
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
  constexpr double large = 1e6;
  CheckRange("maximumEdgeLength", maximumEdgeLength, 0.0, 1e12);
  CheckRange("maximumEdgeLengthFactor", maximumEdgeLengthFactor, 0.1, large);
  CheckRange("adjacencyWeight", energy.adjacencyWeight, 0.0, large);
  CheckRange("neighborWeight", energy.neighborWeight, 0.0, large);
  CheckRange("lengthWeight", energy.lengthWeight, 0.0, large);
  CheckRange("unitLength", energy.unitLength, energy.unitLength == 0.0 ? 0.0 : 1e-12, 1e12);
  CheckRange("delaunayWeight", energy.delaunayWeight, 0.0, large);
  CheckRange("epidermalNeighbors", energy.epidermalNeighbors, 1.0, 100.0);
  CheckRange("innerNeighbors", energy.innerNeighbors, 1.0, 100.0);
  CheckRange("numberOfCycles", annealing.numberOfCycles, 0.0, 1000.0);
  CheckRange("initialTemperature", annealing.initialTemperature, 1e-9, large);
  CheckRange("coolingFactor", annealing.coolingFactor, 1e-9, 1.0);
  CheckRange("maximumDegree", annealing.maximumDegree, 3.0, large);
  CheckRange("trianglesPerCell", trianglesPerCell, 40.0, 10000.0);
  CheckRange("refinement", refinement, 0.0, 3.0);
  CheckRange("smoothingIterations", smoothingIterations, 0.0, 10000.0);
}
} // namespace tissue
