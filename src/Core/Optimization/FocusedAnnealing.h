/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_FocusedAnnealing_h
#define TissueTessellationCore_FocusedAnnealing_h

#include "Optimization/AnnealingState.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Optimization/OptimizationParameters.h"

namespace tissue
{

/** \brief Anneals a complex where it disagrees with its reference.
 *
 * The complex is right nearly everywhere after the ranked cycles, so that the chance to leave a local minimum is worth
 * spending only around what is wrong. Each round lists the tetrahedra that are not in the reference, or have less than
 * four fifths of its votes, and their neighbours. It proposes random edge removals and triangle swaps at them, which
 * the Metropolis rule accepts or not. The best state seen at the end of a round is kept.
 *
 * There must be a reference. `oneQuadruple` is the energy that temperatures are measured in. */
void
AnnealWhereWrong(AnnealingState & state, const FocusedAnnealingParameters & parameters, double oneQuadruple,
                 const Execution & execution = Execution());
} // namespace tissue

#endif
