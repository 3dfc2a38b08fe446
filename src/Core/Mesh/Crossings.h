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
/** Two triangles, the smaller index first. */
using TrianglePair = std::array<std::int32_t, 2>;

/** All pairs of triangles that cross (TriangleCrossing.h), ascending. */
std::vector<TrianglePair>
FindCrossings(const WallMesh & mesh, const Execution & execution = Execution());

/** Those of them with a triangle of the given walls. */
std::vector<TrianglePair>
FindCrossingsOfWalls(const WallMesh & mesh, const std::vector<WallId> & walls,
                     const Execution & execution = Execution());

/** Pairs of triangles whose boxes, about their points here and there, overlap, and of which one is marked. */
std::vector<TrianglePair>
CollectClosePairs(const WallMesh & mesh, const std::vector<Point> & here, const std::vector<Point> & there,
                  const std::vector<unsigned char> & isMarked, const Execution & execution);
} // namespace tissue

#endif
