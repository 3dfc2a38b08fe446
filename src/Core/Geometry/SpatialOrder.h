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
/** Returns the indices of points in their order along a Hilbert curve: what is near in space is near in the order. */
std::vector<std::int32_t>
HilbertOrder(const std::vector<Point> & points);

/** Returns the vertices in their order along a Hilbert curve through their centres, the exterior first whatever its
 * centre. Numbered so, what is near in the tissue is near in memory. The order depends on the centres alone, except
 * among those that coincide, and stays the same where they are turned, mirrored, shifted or scaled together. */
std::vector<VertexId>
SpatialOrder(const std::vector<Point> & centers);

/** Returns the index of each vertex in an order of them. */
std::vector<VertexId>
RanksInOrder(const std::vector<VertexId> & order);
} // namespace tissue

#endif
