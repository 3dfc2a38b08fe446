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

/** Finds the pairs of triangles of which one at least is marked and whose boxes overlap. The box of a triangle is the
 * one about its points both here and there. */
std::vector<TrianglePair>
CollectClosePairs(const WallMesh & mesh, const std::vector<Point> & here, const std::vector<Point> & there,
                  const std::vector<unsigned char> & isMarked, const Execution & execution);
} // namespace tissue

#endif
