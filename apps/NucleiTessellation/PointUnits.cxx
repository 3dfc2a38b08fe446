/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "NucleiTessellation/PointUnits.h"

#include "TissueTessellationCore/Geometry/Box.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
/** What units points and box may have, by how much smaller the points' extent is. */
std::string
GuessUnits(double ratio)
{
  if (ratio < 1e-5)
  {
    return "as if the points were in metres and the box in micrometres";
  }
  if (ratio < 0.01)
  {
    return "as if the points were in millimetres and the box in micrometres";
  }
  return ratio < 50.0 ? "as if one were in voxels and the other in micrometres"
                      : "as if the points were in micrometres and the box in millimetres";
}
} // namespace

void
RequireUnitOfBox(const std::vector<Point> & points, const std::string & pointUnit, const itk::ImageBase<3> * box,
                 const std::string & boxUnit)
{
  constexpr double least = 0.01;
  constexpr double most = 1.2;
  if (points.empty())
  {
    return;
  }
  // In voxels, along the axes of the box.
  const auto toVoxels = [box](const Point & point) {
    const auto index = box->TransformPhysicalPointToContinuousIndex<double>(itk::ImageBase<3>::PointType(point.data()));
    return Point{ { index[0] + 0.5, index[1] + 0.5, index[2] + 0.5 } };
  };
  Box extent{ toVoxels(points.front()), toVoxels(points.front()) };
  for (const Point & point : points)
  {
    Extend(extent, toVoxels(point));
  }
  const auto size = box->GetLargestPossibleRegion().GetSize();
  const auto spacing = box->GetSpacing();
  double     ratio = 0.0;
  double     share = 1.0;
  bool       isOutside = false;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double ofAxis = (extent.upper[i] - extent.lower[i]) / static_cast<double>(size[i]);
    ratio = std::max(ratio, ofAxis);
    share *= ofAxis;
    isOutside = isOutside || extent.lower[i] < 0.0 || extent.upper[i] > static_cast<double>(size[i]);
  }
  if (ratio >= least && !(isOutside && ratio >= most))
  {
    return;
  }
  std::ostringstream text;
  text.precision(3);
  const auto list = [&text](const auto & valueOf) { text << valueOf(0) << " x " << valueOf(1) << " x " << valueOf(2); };
  text << "the points extend over ";
  list([&](int i) { return (extent.upper[i] - extent.lower[i]) * spacing[i]; });
  text << (pointUnit.empty() ? "" : " " + pointUnit) << ", the box over ";
  list([&](int i) { return size[i] * spacing[i]; });
  text << (boxUnit.empty() ? "" : " " + boxUnit) << " (";
  list([&](int i) { return size[i]; });
  text << " voxels of ";
  list([&](int i) { return spacing[i]; });
  text << "), of whose volume they fill " << share << ": they are not in one unit, " << GuessUnits(ratio)
       << "; --spacing X Y Z gives the size of a voxel in the unit of the points";
  throw std::runtime_error(text.str());
}
} // namespace tissue
