/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CellMoments_h
#define TissueTessellationCore_CellMoments_h

#include "TissueTessellationCore/Geometry/Metric.h"

#include <cstddef>
#include <vector>

namespace tissue
{
/** The size, centre and shape of a cell that is given by points. */
struct CellMoments
{
  std::size_t numberOfPoints = 0;
  Point       mean = { { 0.0, 0.0, 0.0 } };
  /** The covariance of the boxes about the points, which is positive definite. */
  Metric covariance = { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
};

/** Measures the moments of all cells, in the order of their indices. Where a cell has no point they are zero, except
 * for the part of the box in the covariance. \param boxSize the sides of the box that each point stands for. */
std::vector<CellMoments>
MeasureCells(const std::vector<Point> & points, const std::vector<std::int32_t> & cellOfPoint,
             std::size_t numberOfCells, const Point & boxSize);
} // namespace tissue

#endif
