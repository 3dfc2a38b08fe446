/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ExactPredicates_h
#define TissueTessellationCore_ExactPredicates_h

#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
/** Returns the sign of the signed volume of the tetrahedron (a, b, c, d), that is of det(b - a, c - a, d - a): +1, -1,
 * or 0 where the four points are coplanar. It is exact for every finite input (CGAL's filtered predicate). */
int
Orientation(const Point & a, const Point & b, const Point & c, const Point & d);

/** Whether two triangles, with their edges and corners, have a point in common. A triangle whose points are equal or on
 * one line is the point or the segment that it covers. The answer is exact (CGAL's predicates). */
bool
TrianglesMeet(const std::array<Point, 3> & s, const std::array<Point, 3> & t);

/** Whether c and d are on the same side of the line through a and b; all four must be coplanar. It is false where one
 * of them is on the line. The answer is exact. */
bool
AreOnOneSide(const Point & a, const Point & b, const Point & c, const Point & d);

/** Whether a plane holds all points, as it does for fewer than four. The answer is exact. */
bool
AreCoplanar(const std::vector<Point> & points);
} // namespace tissue

#endif
