/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SpatialOrder_h
#define TissueTessellationCore_SpatialOrder_h

#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
/** The vertices along a Hilbert curve through their centres, the exterior first whatever its centre: numbered so, what
 * is near in the tissue is near in memory. Depends on the centres alone, but for the order of those that coincide, and
 * stays the same where they are turned, mirrored, shifted or scaled together. */
std::vector<VertexId>
SpatialOrder(const std::vector<Point> & centers);

/** Of each vertex its index in an order of them. */
std::vector<VertexId>
RanksInOrder(const std::vector<VertexId> & order);
} // namespace tissue

#endif
