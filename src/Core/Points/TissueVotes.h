/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueVotes_h
#define TissueTessellationCore_TissueVotes_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Points/TissueGrid.h"
#include "TissueTessellationCore/Tessellation/TissueSamples.h"

#include <vector>

namespace tissue
{
/** \brief Tells how sure it is which cells meet, where a tessellation is an estimate.
 *
 * The tessellation is made anew 32 times from seeds that are all a little off, each time in another way. Cells that
 * meet at a point do so every time where much would have to change for others to meet there in their place, and seldom
 * where it hangs by a thread.
 *
 * \param seeds the seeds of the cells, with metrics of determinant 1.
 * \param spacings the local spacing about each seed.
 * \param samples the points of `grid` that are in the tissue.
 * \param uncertainty the standard deviation of a seed's place along each axis, in units of the spacing. That of the
 * entries of its metric's logarithm is 2.4 times as much, and that of its size 3 times.
 * \param shapeDoubt how much of the way from their own metrics to those of balls the seeds are drawn in the last of the
 * tessellations, 0 .. 1. The share grows evenly from 0 in the first one.
 * \return the votes in ascending order, where vertex i + 1 is the cell of seed i. They are the same for any number of
 * threads. */
std::vector<JunctionVote>
VoteOnJunctions(const std::vector<MetricSeed> & seeds, const std::vector<double> & spacings,
                const TissueSamples & samples, const TissueGrid & grid, double uncertainty, double shapeDoubt,
                const Execution & execution = Execution());
} // namespace tissue

#endif
