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
/** Cell centres as the positions of vertices, after the exterior's, and then the mirror images of some of them. */
struct MirroredCenters
{
  std::vector<Point> positions;
  /** The local spacing of each; 0 of the exterior. */
  std::vector<double> spacings;
  /** The vertex whose image each is, itself where it is none. */
  std::vector<std::size_t> originals;
};

/** Mirrors centres at the sides of a box. A cell whose centre is nearer to a side than 0.4 of the local spacing is
 * taken to be cut by it: there are others beyond, and the images stand for them. At the box's edges and corners images
 * have images. No two positions are the same, if those of the points are not.
 *
 * \param points in the box.
 * \param spacings by vertices, the exterior's first (LocalSpacing.h). */
MirroredCenters
MirrorAtSides(const std::vector<Point> & points, const std::vector<double> & spacings, const Box & box);
} // namespace tissue

#endif
