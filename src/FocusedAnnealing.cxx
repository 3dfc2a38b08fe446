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
/** Shares of the kinds of proposals. */
constexpr double RemovalShare = 0.6;
constexpr double RandomRingShare = 0.5;

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

/** A random operation at a tetrahedron. */
Proposal
ProposeAt(AnnealingState & state, TetrahedronId id, std::int32_t maximumDegree)
{
  const VertexQuadruple & vertices = state.complex.GetTetrahedron(id).vertices;
  if (state.random.Uniform() >= RemovalShare)
  {
    return state.operations.SwapTriangle(id, static_cast<int>(state.random.Index(4)));
  }
  constexpr int    edges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
  const auto &     e = edges[state.random.Index(6)];
  const VertexPair edge{ { vertices[e[0]], vertices[e[1]] } };
  if (state.complex.FindEdge(edge[0], edge[1])->degree > maximumDegree)
  {
    return { Verdict::DegreeAboveLimit, {} };
  }
  if (state.random.Uniform() >= RandomRingShare)
  {
    return state.RemoveEdgeByReference(edge);
  }
  return state.operations.RemoveEdge(
    edge, [&state](VertexPair, const AdjacencyComplex::Ring &, int, int, int) { return state.random.Uniform(); });
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
        state.Try(ProposeAt(state, id, parameters.maximumDegree), temperature);
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
