/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallLines_h
#define TissueTessellationCore_WallLines_h

#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <boost/container/static_vector.hpp>

#include <vector>

namespace tissue
{
/** \brief Where three walls meet, from one corner to another: the dual of a triangle of the complex. Where a cell was
 * divided (LabelDivision.h), two walls meet at its seams. */
struct WallLine
{
  /** The points from the corner of the smaller index to the other corner, which are at least these two. */
  std::vector<PointId> points;
  /** The two or three walls, in ascending order. */
  boost::container::static_vector<WallId, 3> walls;
};

/** \brief The triple lines of a wall mesh, ascending by their ends, then by their walls: the order stays when lines are
 * cut.
 *
 * Every edge in triangles of three walls is on a line, and every line ends at two different corners. */
std::vector<WallLine>
CollectWallLines(const WallMesh & mesh);

/** Of each line, in the order of CollectWallLines(), whether it has both ends in common with another. */
std::vector<bool>
FindDoubledLines(const std::vector<WallLine> & lines);

double
LengthOf(const WallLine & line, const std::vector<Point> & points);

/** \brief The walls at each point of a line or corner, ascending; none are kept for points within a wall. */
class WallsAtPoints
{
public:
  explicit WallsAtPoints(const WallMesh & mesh);

  /** How many walls both points are in. Two points of one line are in three walls; a wall's edge from one side of its
   * outline to another is its own only where this is 1. */
  int
  CountCommon(PointId a, PointId b) const;

private:
  CompressedRows<WallId, std::int32_t> m_Walls;
};
} // namespace tissue

#endif
