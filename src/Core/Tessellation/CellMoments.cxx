/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Tessellation/CellMoments.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
std::vector<CellMoments>
MeasureCells(const std::vector<Point> & points, const std::vector<std::int32_t> & cellOfPoint,
             std::size_t numberOfCells, const Point & boxSize)
{
  std::vector<CellMoments> cells(numberOfCells);
  for (std::size_t i = 0; i < cellOfPoint.size(); ++i)
  {
    CellMoments & cell = cells[static_cast<std::size_t>(cellOfPoint[i])];
    ++cell.numberOfPoints;
    for (std::size_t k = 0; k < 3; ++k)
    {
      cell.mean[k] += points[i][k];
    }
  }
  for (CellMoments & cell : cells)
  {
    for (double & value : cell.mean)
    {
      value /= static_cast<double>(std::max<std::size_t>(cell.numberOfPoints, 1));
    }
  }
  for (std::size_t i = 0; i < cellOfPoint.size(); ++i)
  {
    CellMoments & cell = cells[static_cast<std::size_t>(cellOfPoint[i])];
    AddOuterProduct(1.0 / static_cast<double>(cell.numberOfPoints), points[i] - cell.mean, cell.covariance);
  }
  for (CellMoments & cell : cells)
  {
    cell.covariance[0] += boxSize[0] * boxSize[0] / 12.0;
    cell.covariance[3] += boxSize[1] * boxSize[1] / 12.0;
    cell.covariance[5] += boxSize[2] * boxSize[2] / 12.0;
  }
  return cells;
}
} // namespace tissue
