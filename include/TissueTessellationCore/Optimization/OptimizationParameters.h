/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_OptimizationParameters_h
#define TissueTessellationCore_OptimizationParameters_h

#include "TissueTessellationCore/Complex/Legality.h"

#include <cstddef>
#include <cstdint>

namespace tissue
{
/** Weights and constants of the energy (EnergyFunction.h). The defaults are those of the paper (section 3.4), and 0 for
 * the terms that it does not have. */
struct EnergyParameters
{
  /** The weight of the image term, equation 2. Without a reference the term is 0. */
  double adjacencyWeight = 8.0;
  /** The share of the votes, where the reference has votes, above which a tetrahedron is better than none by the image
   * term. With nearly one half, the complex keeps what is likelier than not. */
  double leastVote = 0.48;
  /** The weight of a term like the image term, but for pairs of cells that share a wall. The paper does not have it. */
  double pairWeight = 0.0;
  /** The weight of the prior on the numbers of neighbours, equation 3. */
  double neighborWeight = 0.05;
  /** The weight of the term of longest edges, equation 4. */
  double lengthWeight = 0.5;
  /** The length by which lengths are divided, 0 or in 1e-12 .. 1e12. With 1 they stay in the image's units, as in the
   * paper; 0 stands for the median local spacing (LocalSpacing.h) of the complex at the start. */
  double unitLength = 1.0;
  /** The weight of the deviation from the Delaunay tetrahedralization (DelaunayDeviation.h), by the local spacings of
   * the complex at the start. The paper does not have this term. */
  double delaunayWeight = 0.0;
  /** The ideal numbers of neighbouring cells of an epidermal and of an inner cell: the means that the paper found in
   * segmented tissues. */
  double epidermalNeighbors = 9.0;
  double innerNeighbors = 13.0;
};

/** How the complex is annealed where it disagrees with its reference (FocusedAnnealing.h). */
struct FocusedAnnealingParameters
{
  /** The number of rounds, each at its own temperature; with 0 nothing is done. */
  int numberOfRounds = 20;
  /** The temperatures of the first and of the last round, between which they fall geometrically, above 0. Their unit is
   * the energy of one quadruple of the reference. In a complex that is nearly right, a right tetrahedron that becomes a
   * wrong one costs nearly two of these units by the image term: the first round accepts that once in 17 times, the
   * last one practically never. */
  double initialTemperature = 0.7;
  double finalTemperature = 0.08;
  /** The number of operations that a round proposes for each tetrahedron of its list. */
  int proposalsPerTetrahedron = 60;
  /** The largest degree of an edge that is removed. */
  std::int32_t maximumDegree = 8;
  /** Whether a complex that has lost a fifth of the best one's energy goes back to the best one. It does not where the
   * best energy is above 0. */
  bool returnsFromMelting = true;
};

/** Which vertices are tried at another place, and how (VertexRelocation.h). More trials take more time. */
struct VertexRelocationParameters
{
  /** A share of a vertex's quadruples in the reference, 0 or more: the vertex is tried where its missing quadruples and
   * its tetrahedra that are not in the reference are together more than that. */
  double wrongShare = 0.25;
  /** The share of all vertices that is tried at most, the worst first: where more are wrong, the rest of the complex is
   * no help to place them by. */
  double largestShare = 0.2;
  /** The number of places that are tried for a vertex, the most promising first. */
  int numberOfPlaces = 2;
  /** The rounds of annealing around the vertex at its new place, the proposals of each for each tetrahedron there, and
   * the temperatures of the first and of the last round, as in FocusedAnnealingParameters. */
  int    numberOfRounds = 10;
  int    proposalsPerTetrahedron = 40;
  double initialTemperature = 0.5;
  double finalTemperature = 0.08;
};

/** How the ring of a removed edge is triangulated. */
enum class RingRule
{
  /** The ring gets the Delaunay triangulation of its projection (paper, section 3.2). */
  ProjectedDelaunay,
  /** The ring gets the triangulation that makes most quadruples of the reference. Where there is no reference, this is
   * ProjectedDelaunay. */
  BestOfReference
};

/** How the complex is annealed (TopologyOptimizer.h). */
struct AnnealingParameters
{
  /** The number of temperature cycles; the paper found five to be enough. */
  int numberOfCycles = 5;
  /** The temperature of the first cycle, above 0, in units of what one element more or less changes. This is the energy
   * of one quadruple of the reference, or, where that has no weight, the weights of neighbours and lengths over the
   * number of cells. Where all those weights are 0, only what lowers the energy is done. */
  double initialTemperature = 0.3;
  /** The factor of the temperature from a cycle to the next, in (0, 1]. */
  double   coolingFactor = 0.5;
  Legality legality = Legality::Geometric;
  RingRule ringRule = RingRule::ProjectedDelaunay;
  /** The largest degree of an edge that is removed in the cycles. The default is so high that it is no limit. */
  std::int32_t maximumDegree = 1000;
  /** Whether the cycles are followed, twice, by annealing where the complex is wrong and by the relocation of vertices,
   * which the paper does not have. This needs a reference and combinatorial legality. Where the reference has votes,
   * the complex is annealed once, by another schedule, and no vertex is moved. */
  bool                       isFocused = false;
  FocusedAnnealingParameters focus;
  VertexRelocationParameters relocation;
  std::uint64_t              seed = 1;
};

/** A record of what happened in one temperature cycle. */
struct AnnealingCycle
{
  double      temperature = 0.0;
  std::size_t numberOfRemovals = 0;
  std::size_t numberOfSwaps = 0;
  /** The energy at the end of the cycle. */
  double energy = 0.0;
};
} // namespace tissue

#endif
