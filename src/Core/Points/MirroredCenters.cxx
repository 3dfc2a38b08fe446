/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/MirroredCenters.h"

#include <cmath>

namespace tissue
{
namespace
{
/** The distance of a centre to a side, in units of the local spacing, below which the cell is taken to be cut by it. A
 * whole cell reaches about half the spacing from its centre. */
constexpr double SideDistance = 0.4;
/** The distance from the side to the plane that is mirrored at is half of this, in units of the local spacing: little,
 * but enough that no centre comes to lie on its image. */
constexpr double MirrorGap = 0.02;
} // namespace

MirroredCenters
MirrorAtSides(const std::vector<Point> & points, const std::vector<double> & spacings, const Box & box)
{
  // The axes follow one another, and images made for one are mirrored for the next, as edges and corners need it.
  MirroredCenters centers{ { { { 0.0, 0.0, 0.0 } } }, spacings, {} };
  centers.positions.insert(centers.positions.end(), points.begin(), points.end());
  for (std::size_t v = 0; v < centers.positions.size(); ++v)
  {
    centers.originals.push_back(v);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::size_t count = centers.positions.size();
    for (std::size_t v = 1; v < count; ++v)
    {
      for (const double outwards : { -1.0, 1.0 })
      {
        const double side = outwards < 0.0 ? box.lower[axis] : box.upper[axis];
        Point        image = centers.positions[v];
        const double distance = std::abs(image[axis] - side);
        if (distance < SideDistance * centers.spacings[v])
        {
          image[axis] = side + outwards * (distance + MirrorGap * centers.spacings[v]);
          centers.positions.push_back(image);
          centers.spacings.push_back(centers.spacings[v]);
          centers.originals.push_back(centers.originals[v]);
        }
      }
    }
  }
  return centers;
}
} // namespace tissue
