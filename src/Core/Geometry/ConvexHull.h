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
/** Volume of the convex hull of the points, by CGAL, exact but for its last rounding; 0 where they are in one plane. */
double
ConvexHullVolume(const std::vector<Point> & points);
} // namespace tissue

#endif
