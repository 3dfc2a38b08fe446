/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Optimization/FocusedAnnealing.h"

namespace tissue
{
namespace
{
/** A share of the best energy so far, which is below 0: a complex that has kept less of it has melted, and goes back to
 * the best one. Where a start is wrong nearly everywhere, a high temperature has nothing to hold on to, and the next
 * round would start from chaos. A share near 1 would undo what annealing is for, that the energy may rise for a while;
 * a share near 0 would let the complex melt. */
constexpr double MeltedShare = 0.8;

std::vector<TetrahedronId>
ListTetrahedra(const AdjacencyComplex & complex)
{
  std::vector<TetrahedronId> list;
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    if (complex.IsAlive(id))
    {
      list.push_back(id);
    }
  }
  return list;
}
} // namespace

void
AnnealWhereWrong(AnnealingState & state, const FocusedAnnealingParameters & parameters, double oneQuadruple,
                 const Execution & execution)
{
  AdjacencyComplex best = state.complex;
  double           bestEnergy = state.energy.Total();
  const Cooling    cooling{ parameters.initialTemperature, parameters.finalTemperature, parameters.numberOfRounds };
  for (int round = 0; round < parameters.numberOfRounds; ++round)
  {
    const double temperature = oneQuadruple * cooling.Temperature(round);
    execution.Report(static_cast<double>(round) / parameters.numberOfRounds);
    const std::vector<TetrahedronId> list = state.WrongAndNeighbors(ListTetrahedra(state.complex));
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
    else if (parameters.returnsFromMelting && bestEnergy < 0.0 && state.energy.Total() > MeltedShare * bestEnergy)
    {
      state.complex = best;
      state.energy.Recompute();
    }
  }
  state.complex = best;
  state.energy.Recompute();
}
} // namespace tissue
