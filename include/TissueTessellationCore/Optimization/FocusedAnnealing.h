/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_FocusedAnnealing_h
#define TissueTessellationCore_FocusedAnnealing_h

#include "TissueTessellationCore/Optimization/AnnealingState.h"
#include "TissueTessellationCore/Common/Progress.h"

namespace tissue
{
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

/** \brief Anneals a complex where it disagrees with its reference.
 *
 * The complex is right nearly everywhere after the ranked cycles; the chance to leave a local minimum is worth spending
 * only around what is wrong. Each round lists the tetrahedra that are not in the reference, or have
 * less than four fifths of its votes, and their neighbours, and
 * proposes random edge removals and triangle swaps at them, by the Metropolis rule. The best state seen at the end of a
 * round is kept.
 *
 * Requires a reference. `oneQuadruple` is the energy that temperatures are measured in. */
void
AnnealWhereWrong(AnnealingState & state, const FocusedAnnealingParameters & parameters, double oneQuadruple,
                 const ProgressFunction & progress = ProgressFunction());
} // namespace tissue

#endif
