/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ConvexHull_h
#define TissueTessellationCore_ConvexHull_h

#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
/** Returns the volume of the points' convex hull, by CGAL, exact except for its last rounding; 0 where all points are
 * in one plane. */
double
ConvexHullVolume(const std::vector<Point> & points);
} // namespace tissue

#endif
