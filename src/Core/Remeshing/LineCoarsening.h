/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LineCoarsening_h
#define TissueTessellationCore_LineCoarsening_h

#include "Mesh/WallLines.h"

#include <vector>

namespace tissue
{
/** \brief Takes points from triple lines, and slides them along, as far as the triangles at them allow.
 *
 * A triangle may not turn over, nor get as flat as a quality of 0.1 unless it was flatter. Triangles that vanish are
 * left with three equal points (IsGone()), points with a numberOfCells of 0. */
class LineCoarsening
{
public:
  explicit LineCoarsening(WallMesh & mesh);

  /** Merges the i-th point of the line, an inner one, with a neighbour on the line, in all three walls.
   * Returns false, and changes nothing, where a rule forbids both. */
  bool
  RemovePoint(WallLine & line, std::size_t i);

  /** Moves a point of a line, unless a triangle at it forbids it. */
  bool
  MovePoint(PointId point, const Point & target);

  static bool
  IsGone(const Triangle & triangle)
  {
    return triangle[0] == triangle[1];
  }

private:
  bool
  CanMerge(PointId point, PointId into, PointId other) const;
  /** Whether the wall is still a disk, and no edge new to it is another wall's. */
  bool
  WallCanMerge(WallId wall, PointId point, PointId into, PointId other) const;
  std::vector<PointId>
  NeighborsIn(WallId wall, PointId point) const;
  /** Whether the triangles at the point, except those with `except`, would be sound with the point elsewhere. */
  bool
  CanBeAt(PointId point, const Point & target, PointId except) const;
  void
  Merge(PointId point, PointId into);

  WallMesh &                             m_Mesh;
  WallsAtPoints                          m_WallsAt;
  std::vector<std::vector<std::int32_t>> m_TrianglesAt;
};
} // namespace tissue

#endif
