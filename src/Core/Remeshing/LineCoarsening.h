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
/** \brief Takes points from triple lines, and slides points along them, as far as the triangles at them allow.
 *
 * No triangle may turn over, nor become worse than a quality of 0.1, or than it was if it was worse. A point is taken
 * away by a collapse: it is merged with a neighbour on its line, and the triangles between the two vanish. Triangles
 * that have vanished are left with three equal points (IsGone()), and such points with a numberOfCells of 0. */
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
  /** Whether a point may be merged with one neighbour on its line, `other` being the other one. */
  bool
  CanMerge(PointId point, PointId into, PointId other) const;
  /** Whether the wall stays a disk, and no edge that is new in it can be another wall's. */
  bool
  WallCanMerge(WallId wall, PointId point, PointId into, PointId other) const;
  /** Returns the points that share an edge of the wall with the point, ascending. */
  std::vector<PointId>
  NeighborsIn(WallId wall, PointId point) const;
  /** Whether the triangles at the point, except those with `except`, would be sound with the point at `target`. */
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
