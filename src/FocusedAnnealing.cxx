/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/FocusedAnnealing.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** The tetrahedra that are not in the reference, and their neighbours, ascending. */
std::vector<TetrahedronId>
ListWrongTetrahedra(const AnnealingState & state)
{
  const AdjacencyComplex &   complex = state.complex;
  std::vector<TetrahedronId> list;
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    if (complex.IsAlive(id) && !state.energy.GetReference()->HasQuadruple(complex.GetTetrahedron(id).vertices))
    {
      const auto & neighbors = complex.GetTetrahedron(id).neighbors;
      list.push_back(id);
      list.insert(list.end(), neighbors.begin(), neighbors.end());
    }
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

} // namespace

void
AnnealWhereWrong(AnnealingState & state, const FocusedAnnealingParameters & parameters, double oneQuadruple,
                 const ProgressFunction & progress)
{
  AdjacencyComplex best = state.complex;
  double           bestEnergy = state.energy.Total();
  const double     cooling = std::pow(parameters.finalTemperature / parameters.initialTemperature,
                                  1.0 / std::max(1, parameters.numberOfRounds - 1));
  double           temperature = parameters.initialTemperature * oneQuadruple;
  for (int round = 0; round < parameters.numberOfRounds; ++round, temperature *= cooling)
  {
    Report(progress, static_cast<double>(round) / parameters.numberOfRounds);
    const std::vector<TetrahedronId> list = ListWrongTetrahedra(state);
    const std::size_t numberOfProposals = list.size() * static_cast<std::size_t>(parameters.proposalsPerTetrahedron);
    for (std::size_t i = 0; i < numberOfProposals; ++i)
    {
      const TetrahedronId id = list[state.random.Index(list.size())];
      if (state.complex.IsAlive(id))
      {
        state.Try(state.ProposeAt(id, parameters.maximumDegree), temperature);
      }
    }
    if (state.energy.Total() < bestEnergy)
    {
      best = state.complex;
      bestEnergy = state.energy.Total();
    }
  }
  state.complex = best;
  state.energy.Recompute();
}
} // namespace tissue
