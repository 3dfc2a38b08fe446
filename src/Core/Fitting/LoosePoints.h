/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LoosePoints_h
#define TissueTessellationCore_LoosePoints_h

#include "TissueTessellationCore/Geometry/Box.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <set>

namespace tissue
{
/** A point of a mesh that a local search may move: the box that it stays in, about its triangles; these triangles;
 * their other points, one entry for each triangle; and all triangles that its own can come to cross while all loose
 * points stay within their boxes. */
struct LoosePoint
{
  PointId                   point = -1;
  Box                       reach{};
  std::vector<std::int32_t> triangles;
  std::vector<PointId>      neighbors;
  std::vector<std::int32_t> close;
};

/** Makes loose points of some, in ascending order, in one pass over the mesh. */
std::vector<LoosePoint>
CollectLoosePoints(const WallMesh & mesh, const std::set<PointId> & points);

/** Counts the pairs of one of the point's triangles and a close one that cross as they are now. */
int
CountCrossings(const WallMesh & mesh, const LoosePoint & entry);
} // namespace tissue

#endif
