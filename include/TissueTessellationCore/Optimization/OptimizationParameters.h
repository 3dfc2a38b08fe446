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
/** Weights and constants of the energy; the defaults are the paper's (section 3.4). */
struct EnergyParameters
{
  /** Of the image term, equation 2; without a reference the term is 0. */
  double adjacencyWeight = 8.0;
  /** With votes: the share of them from which on a tetrahedron is better than none by this term. */
  double leastVote = 0.48;
  /** Of the same term for pairs of cells that share a wall, which the paper has not. */
  double pairWeight = 0.0;
  /** Of the prior on the numbers of neighbours, equation 3. */
  double neighborWeight = 0.05;
  /** Of the longest edges, equation 4. */
  double lengthWeight = 0.5;
  /** What lengths are divided by; 1 leaves them in the image's units, as in the paper, 0 takes the median local spacing
   * (LocalSpacing.h) of the complex at the start; 0 or 1e-12 .. 1e12. */
  double unitLength = 1.0;
  /** Of the deviation from the Delaunay tetrahedralization (DelaunayDeviation.h), by the local spacings of the
   * complex at the start, which the paper has not. */
  double delaunayWeight = 0.0;
  /** Ideal numbers of neighbouring cells of an epidermal and of an inner cell. */
  double epidermalNeighbors = 9.0;
  double innerNeighbors = 13.0;
};

/** How the complex is annealed where it disagrees with its reference (FocusedAnnealing.h). */
struct FocusedAnnealingParameters
{
  /** Rounds, each at its own temperature; 0: none. */
  int numberOfRounds = 20;
  /** Temperatures of the first and the last round, falling geometrically, in units of the energy of one quadruple of
   * the reference; above 0. */
  double initialTemperature = 0.7;
  double finalTemperature = 0.08;
  /** Operations proposed in a round for each tetrahedron of its list. */
  int proposalsPerTetrahedron = 60;
  /** Largest degree of an edge that is removed. */
  std::int32_t maximumDegree = 8;
  /** Whether a complex that has lost a fifth of the best one's energy goes back to it; not where that is above 0. */
  bool returnsFromMelting = true;
};

/** Which vertices are tried at another place, and how (VertexRelocation.h). */
struct VertexRelocationParameters
{
  /** A vertex is tried where its quadruples that are missing and its tetrahedra that are not in the reference are more
   * than this share of its quadruples in the reference; 0 or more. */
  double wrongShare = 0.25;
  /** At most this share of all vertices is tried, the worst first: where more are wrong, the rest of the complex is no
   * help to place them by. */
  double largestShare = 0.2;
  /** Places that are tried for a vertex, the most promising first. */
  int numberOfPlaces = 2;
  /** Rounds of annealing around the vertex at its new place, and proposals in each for each tetrahedron there. */
  int    numberOfRounds = 10;
  int    proposalsPerTetrahedron = 40;
  double initialTemperature = 0.5;
  double finalTemperature = 0.08;
};

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
} // namespace tissue

#endif
