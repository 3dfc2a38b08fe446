/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_MirroredCenters_h
#define TissueTessellationCore_MirroredCenters_h

#include "TissueTessellationCore/Geometry/Box.h"

#include <cstddef>
#include <vector>

namespace tissue
{
/** The positions of vertices: that of the exterior, which means nothing, the cells' centres, and the mirror images of
 * some of these. */
struct MirroredCenters
{
  std::vector<Point> positions;
  /** The local spacing at each position; that of the exterior is 0. */
  std::vector<double> spacings;
  /** The vertex of which each position is an image; its own number where it is not an image. */
  std::vector<std::size_t> originals;
};

/** Mirrors centres at the sides of a box. A cell whose centre is nearer to a side than 0.4 of the local spacing is
 * taken to be cut by it. There are other cells beyond, and the images stand for them. At the box's edges and corners
 * images have images. No two positions are the same if no two points are.
 *
 * \param points the centres, all in the box.
 * \param spacings the local spacings by vertices, the exterior's first (LocalSpacing.h). */
MirroredCenters
MirrorAtSides(const std::vector<Point> & points, const std::vector<double> & spacings, const Box & box);
} // namespace tissue

#endif
