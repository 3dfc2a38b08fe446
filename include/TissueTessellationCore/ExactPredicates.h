/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ExactPredicates_h
#define TissueTessellationCore_ExactPredicates_h

#include "TissueTessellationCore/Types.h"

#include <vector>

namespace tissue
{
/** Sign of the signed volume of the tetrahedron (a, b, c, d), that is of det(b - a, c - a, d - a): +1, 0 where the four
 * points are coplanar, or -1. Exact for every finite input (CGAL's filtered predicate). */
int
Orientation(const Point & a, const Point & b, const Point & c, const Point & d);

/** Whether a plane holds all points; true for fewer than four. Exact. */
bool
AreCoplanar(const std::vector<Point> & points);
} // namespace tissue

#endif
