/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TopologyOptimizer_h
#define TissueTessellationCore_TopologyOptimizer_h

#include "TissueTessellationCore/Optimization/FocusedAnnealing.h"
#include "TissueTessellationCore/Optimization/VertexRelocation.h"

namespace tissue
{
/** How the ring of a removed edge is triangulated. */
enum class RingRule
{
  /** By the Delaunay triangulation of its projection (paper, section 3.2). */
  ProjectedDelaunay,
  /** By the triangulation that makes most quadruples of the reference; where there is no reference, as above. */
  BestOfReference
};

struct AnnealingParameters
{
  int numberOfCycles = 5;
  /** Temperature of the first cycle, in units of what one element more or less changes: the energy of one quadruple
   * of the reference, or, where that has no weight, the weights of neighbours and lengths over the number of cells.
   * Above 0; where all those weights are 0, only what lowers the energy is done. */
  double initialTemperature = 0.3;
  /** Factor of the temperature from a cycle to the next; in (0, 1]. */
  double   coolingFactor = 0.5;
  Legality legality = Legality::Geometric;
  RingRule ringRule = RingRule::ProjectedDelaunay;
  /** Largest degree of an edge that is removed. */
  std::int32_t maximumDegree = 1000;
  /** Whether the cycles are followed by annealing where the complex is wrong and by the relocation of vertices, twice,
   * which the paper has not; where there is a reference and legality is combinatorial. With votes it is annealed once,
   * by a schedule of their own, and no vertex is moved. */
  bool                       isFocused = false;
  FocusedAnnealingParameters focus;
  VertexRelocationParameters relocation;
  std::uint64_t              seed = 1;
};

/** What happened in one temperature cycle. */
struct AnnealingCycle
{
  double      temperature = 0.0;
  std::size_t numberOfRemovals = 0;
  std::size_t numberOfSwaps = 0;
  /** Energy at the end of the cycle. */
  double energy = 0.0;
};

/** \brief Minimizes the energy of a complex by simulated annealing (paper, section 3.4).
 *
 * Each temperature cycle has two phases, edge removals and triangle swaps. In a phase the legal operations are ranked
 * by their energy difference, ascending, and carried out in that order where they are still legal, at their difference
 * at that time: always where it lowers the energy, else with probability exp(-difference / temperature).
 *
 * The complex ends in the state of least energy seen at the end of a cycle or round, or at the start. The same input,
 * parameters and seed give the same result. */
class TopologyOptimizer
{
public:
  /** References must outlive this object; `reference` may be null.
   * \throws std::invalid_argument where a parameter is out of its range. */
  TopologyOptimizer(AdjacencyComplex & complex, const std::vector<Point> & centers,
                    const ReferenceAdjacency * reference, const EnergyParameters & energy,
                    const AnnealingParameters & annealing);

  /** \throws Aborted where `progress` asks to stop; the complex is then valid, but not yet optimal. */
  std::vector<AnnealingCycle>
  Run(const ProgressFunction & progress = ProgressFunction());

  /** Of the last Run(). */
  std::size_t
  NumberOfRelocatedVertices() const
  {
    return m_NumberOfRelocatedVertices;
  }

  /** The energy of the complex. */
  double
  Energy() const
  {
    return m_State.energy.Total();
  }

private:
  struct Candidate;

  std::vector<AnnealingCycle>
  RunCycles(const ProgressFunction & progress);

  Proposal
  ProposeRemoval(VertexPair edge) const;

  std::size_t
  RemoveEdges(double temperature);

  std::size_t
  SwapTriangles(double temperature);

  /** The unit of temperatures. */
  double
  OneElement() const;

  AnnealingState      m_State;
  EnergyParameters    m_EnergyParameters;
  AnnealingParameters m_Annealing;
  std::size_t         m_NumberOfRelocatedVertices = 0;
};
} // namespace tissue

#endif
