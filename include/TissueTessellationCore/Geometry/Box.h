/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Box_h
#define TissueTessellationCore_Box_h

#include "TissueTessellationCore/Common/Types.h"

#include <algorithm>
#include <vector>

namespace tissue
{
/** A box along the axes, its sides included. It is one point where its two corners are equal. */
struct Box
{
  Point lower;
  Point upper;
};

/** Whether two boxes have a point in common. */
inline bool
Overlap(const Box & a, const Box & b)
{
  return a.lower[0] <= b.upper[0] && b.lower[0] <= a.upper[0] && a.lower[1] <= b.upper[1] && b.lower[1] <= a.upper[1] &&
         a.lower[2] <= b.upper[2] && b.lower[2] <= a.upper[2];
}

/** Makes a box as large as it must be to hold a point. */
inline void
Extend(Box & box, const Point & p)
{
  for (int i = 0; i < 3; ++i)
  {
    box.lower[i] = std::min(box.lower[i], p[i]);
    box.upper[i] = std::max(box.upper[i], p[i]);
  }
}

inline Box
BoxOfTriangle(const std::vector<Point> & points, const Triangle & triangle)
{
  Box box{ points[triangle[0]], points[triangle[0]] };
  Extend(box, points[triangle[1]]);
  Extend(box, points[triangle[2]]);
  return box;
}
} // namespace tissue

#endif
