/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/PointJunctions.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace tissue
{
JunctionSet
MakePointJunctions(const std::vector<Point> & points, const std::vector<Label> & labels)
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
  JunctionSet result;
  result.cells.resize(1);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (labels[i] <= result.cells.back().label)
    {
      throw std::invalid_argument("Label " + std::to_string(labels[i]) + " comes after " +
                                  std::to_string(result.cells.back().label) + ", labels must ascend from above 0");
    }
    for (const double coordinate : points[i])
    {
      if (!std::isfinite(coordinate))
      {
        throw std::invalid_argument("The point of label " + std::to_string(labels[i]) + " has the coordinate " +
                                    std::to_string(coordinate) + ", must be finite");
      }
    }
    Cell cell;
    cell.label = labels[i];
    cell.center = points[i];
    result.cells.push_back(cell);
  }
  return result;
}
} // namespace tissue
