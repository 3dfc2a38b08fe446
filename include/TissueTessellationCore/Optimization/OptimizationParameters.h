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
  std::int32_t  maximumDegree = 1000;
  std::uint64_t seed = 1;
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
