/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TopologyOptimizer_h
#define TissueTessellationCore_TopologyOptimizer_h

#include "Complex/LocalOperations.h"
#include "Optimization/EnergyFunction.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Optimization/OptimizationParameters.h"

namespace tissue
{

/** \brief Minimizes the energy of a complex by simulated annealing (paper, section 3.4).
 *
 * Each temperature cycle has two phases, edge removals and triangle swaps. In a phase the legal operations are ranked
 * by their energy difference, ascending. In that order each is carried out if it is still legal and is accepted at its
 * difference at that time: always where it lowers the energy, else with probability exp(-difference / temperature).
 *
 * The complex ends in the state of least energy seen at the end of a cycle, or at the start. The same input,
 * parameters and seed give the same result. */
class TopologyOptimizer
{
public:
  /** All references must outlive this object. `reference` may be null.
   * \throws std::invalid_argument where a parameter is out of its range. */
  TopologyOptimizer(AdjacencyComplex & complex, const std::vector<Point> & centers,
                    const ReferenceAdjacency * reference, const EnergyParameters & energy,
                    const AnnealingParameters & annealing);

  /** Runs all cycles and returns what happened in each.
   * \throws Aborted where `execution` asks to stop; the complex is then valid, but not yet optimal. */
  std::vector<AnnealingCycle>
  Run(const Execution & execution = Execution());

  /** Returns the energy of the complex. */
  double
  Energy() const
  {
    return m_Energy.Total();
  }

private:
  struct Candidate;

  /** Proposes the removal of an edge, its ring triangulated by the rule. */
  Proposal
  ProposeRemoval(VertexPair edge) const;

  /** Carries out a proposal if it is accepted, by the Metropolis rule: a legal one is where it lowers the energy, else
   * with probability exp(-difference / temperature). Returns whether it was. */
  bool
  Try(const Proposal & proposal, double temperature);

  /** Returns the vertex on the other side of triangle i of a tetrahedron. */
  VertexId
  VertexBehind(TetrahedronId id, int i) const;

  /** Does one phase at a temperature and returns the number of edges that it removed. */
  std::size_t
  RemoveEdges(double temperature);

  /** Does one phase at a temperature and returns the number of triangles that it swapped. */
  std::size_t
  SwapTriangles(double temperature);

  /** Returns the energy that temperatures are measured in: about what one element more or less changes. */
  double
  OneElement() const;

  AdjacencyComplex &  m_Complex;
  LocalOperations     m_Operations;
  EnergyFunction      m_Energy;
  Random              m_Random;
  EnergyParameters    m_EnergyParameters;
  AnnealingParameters m_Annealing;
};
} // namespace tissue

#endif
