/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Points/PointJunctions.h"

#include "TissueTessellationCore/Geometry/PointRange.h"

#include <stdexcept>
#include <string>

namespace tissue
{
JunctionSet
MakePointJunctions(const std::vector<Point> & points, const std::vector<Label> & labels, Label exteriorLabel)
{
  constexpr std::size_t minimum = 4;
  if (points.size() < minimum)
  {
    throw std::invalid_argument("There are " + std::to_string(points.size()) + " points, at least " +
                                std::to_string(minimum) + " are needed");
  }
  if (points.size() != labels.size())
  {
    throw std::invalid_argument("There are " + std::to_string(points.size()) + " points, but " +
                                std::to_string(labels.size()) + " labels");
  }
  RequirePointRange(points, [&labels](std::size_t i) { return "The point of label " + std::to_string(labels[i]); });
  JunctionSet result;
  result.cells.resize(1);
  result.cells[ExteriorVertex].label = exteriorLabel;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (labels[i] == exteriorLabel)
    {
      throw std::invalid_argument("Label " + std::to_string(labels[i]) + " of a point is the exterior's");
    }
    if (i > 0 && labels[i] <= labels[i - 1])
    {
      throw std::invalid_argument("Label " + std::to_string(labels[i]) + " comes after " +
                                  std::to_string(labels[i - 1]) + ", labels must ascend");
    }
    Cell cell;
    cell.label = labels[i];
    cell.center = points[i];
    result.cells.push_back(cell);
  }
  return result;
}
} // namespace tissue
