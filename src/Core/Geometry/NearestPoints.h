/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_NearestPoints_h
#define TissueTessellationCore_NearestPoints_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
/** \brief Finds the points nearest to each point, by a k-d tree: in any arrangement, also in a plane or on a line.
 *
 * \return the other points by ascending distance, as many as asked for or all there are; of several at one distance
 * those of least index are first. */
std::vector<std::vector<std::size_t>>
FindNearestPoints(const std::vector<Point> & points, std::size_t count, const Execution & execution = Execution());
} // namespace tissue

#endif
