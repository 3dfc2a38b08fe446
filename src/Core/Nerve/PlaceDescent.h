/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PlaceDescent_h
#define TissueTessellationCore_PlaceDescent_h

#include "Nerve/PlaceEnergy.h"

namespace tissue
{
struct PlaceDescentResult
{
  double       energyBefore = 0.0;
  double       energyAfter = 0.0;
  std::int64_t numberOfMoves = 0;
};

/** \brief Lowers the energy of a complex by single moves until none lowers it: 2-3, edge removal, 2-0 and 0-2. Then
 * also by moves that cost nothing, each with one that lowers the energy beside it and was not possible before.
 *
 * Tetrahedra are visited in the order of their ids, then those that moves have made or touched, in their order: no
 * chance, no temperature. Links stay what they are. The nerve, where it starts, has nearly all walls and corners of the
 * image already, and small false ones by the diagonals of the subdivision; annealing from there gains nothing more
 * (findings on the general complex, section 5). */
PlaceDescentResult
Descend(GeneralComplex & complex, const TissuePlaces & places, const PlacePreferences & preferences,
        const Execution & execution = Execution());

/** The same where votes are known on which cells meet (PlaceEnergy.h), best with PlacePreferences::ByVotes(). Annealing
 * after it gains nothing here either. */
PlaceDescentResult
Descend(GeneralComplex & complex, const TissuePlaces & places, const PlacePreferences & preferences,
        const std::vector<JunctionVote> & votes, const Execution & execution = Execution());
} // namespace tissue

#endif
