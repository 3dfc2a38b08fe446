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
/** In units of the local spacing. */
constexpr double SideDistance = 0.4;
/** Between the side and the plane that is mirrored at, so that no centre comes to lie on its image. */
constexpr double MirrorGap = 0.02;
} // namespace

MirroredCenters
MirrorAtSides(const std::vector<Point> & points, const std::vector<double> & spacings, const Box & box)
{
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
