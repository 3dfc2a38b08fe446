/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Geometry/PointRange.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
/** The bounds for the size of coordinates and for the points' extent, in the units of the points. They are wide enough
 * for every unit of length, and the squares of volumes, 1e180 and 1e-180, are doubles of full precision still. */
constexpr double LargestCoordinate = 1e30;
constexpr double LeastExtent = 1e-30;
} // namespace

void
RequirePointRange(const std::vector<Point> & points, const std::function<std::string(std::size_t)> & nameOf)
{
  double extent = points.empty() ? LeastExtent : 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double coordinate = points[i][axis];
      if (!(std::abs(coordinate) <= LargestCoordinate))
      {
        std::ostringstream message;
        message << nameOf(i) << " has the coordinate " << coordinate << ", must be finite and at most "
                << LargestCoordinate << " in size";
        throw std::invalid_argument(message.str());
      }
      extent = std::max(extent, std::abs(coordinate - points.front()[axis]));
    }
  }
  if (extent < LeastExtent)
  {
    std::ostringstream message;
    message << "The points extend over " << extent << ", must be " << LeastExtent << " at least";
    throw std::invalid_argument(message.str());
  }
}

std::optional<std::size_t>
FindPointOutside(const std::vector<Point> & points, const Box & box)
{
  const auto at = std::find_if_not(points.begin(), points.end(), [&box](const Point & p) {
    return Overlap({ p, p }, box);
  });
  return at == points.end() ? std::nullopt : std::optional<std::size_t>(at - points.begin());
}
} // namespace tissue
