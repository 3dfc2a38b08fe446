/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueGrid_h
#define TissueTessellationCore_TissueGrid_h

#include "TissueTessellationCore/Geometry/Box.h"

#include <cstddef>

namespace tissue
{
/** Points at the middle of equal boxes, which fill a larger one. */
struct TissueGrid
{
  std::array<std::int32_t, 3> size = { { 0, 0, 0 } };
  /** The corner of the box, half a step before the first grid point. */
  Point lower = { { 0.0, 0.0, 0.0 } };
  /** Between grid points along each axis. */
  Point steps = { { 1.0, 1.0, 1.0 } };

  std::size_t
  NumberOfPoints() const
  {
    return static_cast<std::size_t>(size[0]) * size[1] * size[2];
  }

  Point
  Position(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return { { lower[0] + (x + 0.5) * steps[0], lower[1] + (y + 0.5) * steps[1], lower[2] + (z + 0.5) * steps[2] } };
  }

  /** Of a grid point in the order of the points, the first axis fastest. */
  std::size_t
  Offset(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return (static_cast<std::size_t>(z) * size[1] + y) * size[0] + x;
  }

  /** Of the grid point whose box holds the position, or the nearest one. */
  std::size_t
  OffsetAt(const Point & position) const;
};

/** The grid of about the given distance of points along each axis, a whole number of them. */
TissueGrid
MakeTissueGrid(const Box & box, double step);
} // namespace tissue

#endif
