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
/** Sign of the signed volume of the tetrahedron (a, b, c, d), that is of det(b - a, c - a, d - a): +1, 0 where the four
 * points are coplanar, or -1. Exact for every finite input (CGAL's filtered predicate). */
int
Orientation(const Point & a, const Point & b, const Point & c, const Point & d);

/** Whether two triangles, their edges and corners counted, have a point in common. Points of a triangle may be equal or
 * on one line: it is the segment or the point that it covers. Exact (CGAL's predicates). */
bool
TrianglesMeet(const std::array<Point, 3> & s, const std::array<Point, 3> & t);

/** Whether c and d are on the same side of the line through a and b, all four coplanar; false where one of them is on
 * the line. Exact. */
bool
AreOnOneSide(const Point & a, const Point & b, const Point & c, const Point & d);

/** Whether a plane holds all points; true for fewer than four. Exact. */
bool
AreCoplanar(const std::vector<Point> & points);
} // namespace tissue

#endif
