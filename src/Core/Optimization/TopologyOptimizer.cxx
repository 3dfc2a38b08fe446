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
  : m_Complex(complex)
  , m_Operations(complex, centers, annealing.legality)
  , m_Energy(complex, centers, reference, energy)
  , m_Random(annealing.seed)
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
  m_Operations.SetMaximumDegree(annealing.maximumDegree);
}

double
TopologyOptimizer::OneElement() const
{
  const ReferenceAdjacency * const reference = m_Energy.GetReference();
  if (!reference || m_EnergyParameters.adjacencyWeight == 0.0)
  {
    return (m_EnergyParameters.neighborWeight + m_EnergyParameters.lengthWeight) /
           static_cast<double>(m_Complex.NumberOfVertices());
  }
  return m_EnergyParameters.adjacencyWeight / std::max<double>(1.0, reference->NumberOfQuadruples());
}

std::vector<AnnealingCycle>
TopologyOptimizer::Run(const Execution & execution)
{
  std::vector<AnnealingCycle> cycles;
  AdjacencyComplex            best = m_Complex;
  double                      bestEnergy = m_Energy.Total();
  AnnealingCycle              cycle;
  cycle.temperature = m_Annealing.initialTemperature * OneElement();
  for (int i = 0; i < m_Annealing.numberOfCycles; ++i)
  {
    execution.Report(static_cast<double>(i) / m_Annealing.numberOfCycles);
    cycle.numberOfRemovals = RemoveEdges(cycle.temperature);
    cycle.numberOfSwaps = SwapTriangles(cycle.temperature);
    cycle.energy = m_Energy.Total();
    cycles.push_back(cycle);
    if (cycle.energy < bestEnergy)
    {
      best = m_Complex;
      bestEnergy = cycle.energy;
    }
    cycle.temperature *= m_Annealing.coolingFactor;
  }
  m_Complex = best;
  m_Energy.Recompute();
  execution.Report(1.0);
  return cycles;
}

Proposal
TopologyOptimizer::ProposeRemoval(VertexPair edge) const
{
  if (m_Annealing.ringRule == RingRule::ProjectedDelaunay || !m_Energy.GetReference())
  {
    return m_Operations.RemoveEdge(edge);
  }
  const ReferenceAdjacency & reference = *m_Energy.GetReference();
  return m_Operations.RemoveEdge(edge, [&](const AdjacencyComplex::Ring & ring, int i, int j, int k) {
    const VertexId a = ring.vertices[i];
    const VertexId b = ring.vertices[j];
    const VertexId c = ring.vertices[k];
    // The triangle makes two tetrahedra, one with each end of the edge: its cost is the number that the image has not.
    return 2.0 - (reference.HasQuadruple({ { edge[0], a, b, c } }) ? 1.0 : 0.0) -
           (reference.HasQuadruple({ { edge[1], a, b, c } }) ? 1.0 : 0.0);
  });
}

bool
TopologyOptimizer::Try(const Proposal & proposal, double temperature)
{
  if (!proposal)
  {
    return false;
  }
  const double difference = m_Energy.Difference(proposal.replacement);
  const bool   isAccepted = difference <= 0.0 || m_Random.Uniform() < std::exp(-difference / temperature);
  if (isAccepted)
  {
    m_Energy.Update(proposal.replacement);
    m_Complex.Apply(proposal.replacement);
  }
  return isAccepted;
}

VertexId
TopologyOptimizer::VertexBehind(TetrahedronId id, int i) const
{
  return m_Complex.GetTetrahedron(m_Complex.GetTetrahedron(id).neighbors[i]).vertices[m_Complex.MirrorIndex(id, i)];
}

std::size_t
TopologyOptimizer::RemoveEdges(double temperature)
{
  std::vector<Candidate> candidates;
  for (const AdjacencyComplex::Edge & edge : m_Complex.GetEdges())
  {
    if (const Proposal proposal = ProposeRemoval(edge.vertices))
    {
      const double difference = m_Energy.Difference(proposal.replacement);
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
    if (m_Complex.FindEdge(edge[0], edge[1]) && Try(ProposeRemoval(edge), temperature))
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
  for (TetrahedronId id = 0; id < m_Complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; m_Complex.IsAlive(id) && i < 4; ++i)
    {
      // Each triangle is taken from one of its sides only.
      if (m_Complex.GetTetrahedron(id).neighbors[i] < id)
      {
        continue;
      }
      if (const Proposal proposal = m_Operations.SwapTriangle(id, i))
      {
        const double difference = m_Energy.Difference(proposal.replacement);
        if (difference <= HopelessTemperatures * temperature)
        {
          candidates.push_back({ difference, m_Complex.GetTetrahedron(id).vertices, id, i, VertexBehind(id, i) });
        }
      }
    }
  }
  Rank(candidates);
  std::size_t done = 0;
  for (const Candidate & c : candidates)
  {
    const bool unchanged = m_Complex.IsAlive(c.tetrahedron) &&
                           m_Complex.GetTetrahedron(c.tetrahedron).vertices == c.vertices &&
                           VertexBehind(c.tetrahedron, c.opposite) == c.behind;
    if (unchanged && Try(m_Operations.SwapTriangle(c.tetrahedron, c.opposite), temperature))
    {
      ++done;
    }
  }
  return done;
}
} // namespace tissue
