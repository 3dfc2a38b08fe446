/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Optimization/TopologyOptimizer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tissue
{
/** An operation with its energy difference when the phase was ranked. For a removal, `vertices` holds the edge. For a
 * swap it holds the tetrahedron's vertices: they and the vertex behind the triangle tell whether it is still the same.
 */
struct TopologyOptimizer::Candidate
{
  double          difference;
  VertexQuadruple vertices;
  TetrahedronId   tetrahedron;
  int             opposite;
  VertexId        behind;
};

namespace
{
/** The energy difference, in temperatures, above which an operation is not even ranked: it would be accepted with a
 * probability of exp(-40), below 1e-17. */
constexpr double HopelessTemperatures = 40.0;

/** Returns the schedule of focused annealing for a reference with votes. There most tetrahedra are in doubt, so that
 * the lists are long, and each tetrahedron gets few proposals in few rounds. The energy of a good complex is not known
 * to be below 0, so that no share of it can tell a melted one. */
FocusedAnnealingParameters
VoteAnnealing()
{
  FocusedAnnealingParameters parameters;
  parameters.initialTemperature = 0.5;
  parameters.numberOfRounds = 12;
  parameters.proposalsPerTetrahedron = 6;
  parameters.returnsFromMelting = false;
  return parameters;
}

template <typename TCandidates>
void
Rank(TCandidates & candidates)
{
  // The candidates come in the same order in every run, and a stable sort keeps it among equals.
  std::stable_sort(
    candidates.begin(), candidates.end(), [](const auto & a, const auto & b) { return a.difference < b.difference; });
}
} // namespace

TopologyOptimizer::TopologyOptimizer(AdjacencyComplex & complex, const std::vector<Point> & centers,
                                     const ReferenceAdjacency * reference, const EnergyParameters & energy,
                                     const AnnealingParameters & annealing)
  : m_State{ complex,
             LocalOperations(complex, centers, annealing.legality),
             EnergyFunction(complex, centers, reference, energy),
             Random(annealing.seed) }
  , m_EnergyParameters(energy)
  , m_Annealing(annealing)
{
  const auto require = [](bool valid, const char * what, double value) {
    if (!valid)
    {
      throw std::invalid_argument(std::string("TopologyOptimizer: ") + what + ", is " + std::to_string(value));
    }
  };
  require(annealing.numberOfCycles >= 0, "number of cycles must not be negative", annealing.numberOfCycles);
  require(annealing.initialTemperature > 0, "initial temperature must be above 0", annealing.initialTemperature);
  require(annealing.coolingFactor > 0 && annealing.coolingFactor <= 1,
          "cooling factor must be above 0 and at most 1",
          annealing.coolingFactor);
  require(annealing.maximumDegree >= 3, "maximum degree must be at least 3", annealing.maximumDegree);
  m_State.operations.SetMaximumDegree(annealing.maximumDegree);
}

double
TopologyOptimizer::OneElement() const
{
  // A share of the votes: by so much those of a tetrahedron and of the one that takes its place are taken to differ.
  constexpr double                 changeOfVotes = 0.2;
  const ReferenceAdjacency * const reference = m_State.energy.GetReference();
  if (!reference || m_EnergyParameters.adjacencyWeight == 0.0)
  {
    return (m_EnergyParameters.neighborWeight + m_EnergyParameters.lengthWeight) /
           static_cast<double>(m_State.complex.NumberOfVertices());
  }
  return (reference->HasVotes() ? changeOfVotes : 1.0) * m_EnergyParameters.adjacencyWeight /
         std::max<double>(1.0, reference->NumberOfQuadruples());
}

std::vector<AnnealingCycle>
TopologyOptimizer::Run(const Execution & execution)
{
  const bool isFocused =
    m_Annealing.isFocused && m_State.energy.GetReference() && m_Annealing.legality == Legality::Combinatorial;
  const std::vector<AnnealingCycle> cycles = RunCycles(execution.Part(0.0, isFocused ? 0.4 : 1.0));
  if (isFocused && m_State.energy.GetReference()->HasVotes())
  {
    AnnealWhereWrong(m_State, VoteAnnealing(), OneElement(), execution.Part(0.4, 1.0));
  }
  else if (isFocused)
  {
    AnnealWhereWrong(m_State, m_Annealing.focus, OneElement(), execution.Part(0.4, 0.6));
    m_NumberOfRelocatedVertices =
      RelocateVertices(m_State, m_Annealing.relocation, OneElement(), execution.Part(0.6, 0.8));
    // All this is done a second time, and milder: a vertex that came to its place may have opened the way for others.
    FocusedAnnealingParameters milder = m_Annealing.focus;
    milder.initialTemperature *= 0.5;
    milder.numberOfRounds /= 2;
    AnnealWhereWrong(m_State, milder, OneElement(), execution.Part(0.8, 0.9));
    m_NumberOfRelocatedVertices +=
      RelocateVertices(m_State, m_Annealing.relocation, OneElement(), execution.Part(0.9, 1.0));
  }
  execution.Report(1.0);
  return cycles;
}

std::vector<AnnealingCycle>
TopologyOptimizer::RunCycles(const Execution & execution)
{
  std::vector<AnnealingCycle> cycles;
  AdjacencyComplex            best = m_State.complex;
  double                      bestEnergy = m_State.energy.Total();
  AnnealingCycle              cycle;
  cycle.temperature = m_Annealing.initialTemperature * OneElement();
  for (int i = 0; i < m_Annealing.numberOfCycles; ++i)
  {
    execution.Report(static_cast<double>(i) / m_Annealing.numberOfCycles);
    cycle.numberOfRemovals = RemoveEdges(cycle.temperature);
    cycle.numberOfSwaps = SwapTriangles(cycle.temperature);
    cycle.energy = m_State.energy.Total();
    cycles.push_back(cycle);
    if (cycle.energy < bestEnergy)
    {
      best = m_State.complex;
      bestEnergy = cycle.energy;
    }
    cycle.temperature *= m_Annealing.coolingFactor;
  }
  m_State.complex = best;
  m_State.energy.Recompute();
  return cycles;
}

Proposal
TopologyOptimizer::ProposeRemoval(VertexPair edge) const
{
  if (m_Annealing.ringRule == RingRule::ProjectedDelaunay || !m_State.energy.GetReference())
  {
    return m_State.operations.RemoveEdge(edge);
  }
  return m_State.RemoveEdgeByReference(edge);
}

std::size_t
TopologyOptimizer::RemoveEdges(double temperature)
{
  std::vector<Candidate> candidates;
  for (const AdjacencyComplex::Edge & edge : m_State.complex.GetEdges())
  {
    if (const Proposal proposal = ProposeRemoval(edge.vertices))
    {
      const double difference = m_State.energy.Difference(proposal.replacement);
      if (difference <= HopelessTemperatures * temperature)
      {
        candidates.push_back({ difference, { { edge.vertices[0], edge.vertices[1], 0, 0 } }, 0, 0, 0 });
      }
    }
  }
  Rank(candidates);
  std::size_t done = 0;
  for (const Candidate & candidate : candidates)
  {
    const VertexPair edge{ { candidate.vertices[0], candidate.vertices[1] } };
    if (m_State.complex.FindEdge(edge[0], edge[1]) && m_State.Try(ProposeRemoval(edge), temperature))
    {
      ++done;
    }
  }
  return done;
}

std::size_t
TopologyOptimizer::SwapTriangles(double temperature)
{
  // The phase ranks the legal swaps by their differences now; then it proposes each anew in that order, as far as its
  // triangle has not changed.
  std::vector<Candidate> candidates;
  for (TetrahedronId id = 0; id < m_State.complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; m_State.complex.IsAlive(id) && i < 4; ++i)
    {
      // Each triangle is taken from one of its sides only.
      if (m_State.complex.GetTetrahedron(id).neighbors[i] < id)
      {
        continue;
      }
      if (const Proposal proposal = m_State.operations.SwapTriangle(id, i))
      {
        const double difference = m_State.energy.Difference(proposal.replacement);
        if (difference <= HopelessTemperatures * temperature)
        {
          candidates.push_back(
            { difference, m_State.complex.GetTetrahedron(id).vertices, id, i, m_State.VertexBehind(id, i) });
        }
      }
    }
  }
  Rank(candidates);
  std::size_t done = 0;
  for (const Candidate & c : candidates)
  {
    const bool unchanged = m_State.complex.IsAlive(c.tetrahedron) &&
                           m_State.complex.GetTetrahedron(c.tetrahedron).vertices == c.vertices &&
                           m_State.VertexBehind(c.tetrahedron, c.opposite) == c.behind;
    if (unchanged && m_State.Try(m_State.operations.SwapTriangle(c.tetrahedron, c.opposite), temperature))
    {
      ++done;
    }
  }
  return done;
}
} // namespace tissue
