/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Crossings_h
#define TissueTessellationCore_Crossings_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <functional>
#include <vector>

namespace tissue
{
/** The indices of two triangles, of which the smaller is the first. */
using TrianglePair = std::array<std::int32_t, 2>;

/** Finds all pairs of triangles that cross (TriangleCrossing.h), in ascending order. */
std::vector<TrianglePair>
FindCrossings(const WallMesh & mesh, const Execution & execution = Execution());

/** Finds all pairs of triangles that cross and of which one at least is in one of the given walls, in ascending order.
 */
std::vector<TrianglePair>
FindCrossingsOfWalls(const WallMesh & mesh, const std::vector<WallId> & walls,
                     const Execution & execution = Execution());

/** Tells something of a pair of triangles; called from any thread. */
using TrianglePairTest = std::function<bool(const TrianglePair &)>;

/** \brief Selects, in no order, the pairs of triangles whose boxes overlap, of which one at least is marked, and for
 * which the test holds.
 *
 * With `mayMeetWithin` false pairs within a wall that is a height field (HeightField.h) are left out, none of which
 * cross. What is far from all marked triangles costs little time. */
std::vector<TrianglePair>
SelectClosePairs(const WallMesh & mesh, const std::vector<unsigned char> & isMarked, bool mayMeetWithin,
                 const TrianglePairTest & test, const Execution & execution);
} // namespace tissue

#endif
