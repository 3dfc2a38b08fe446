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
/** \brief The middles of equal boxes that fill a larger one. */
struct TissueGrid
{
  std::array<std::int32_t, 3> size = { { 0, 0, 0 } };
  /** The corner of the box, half a step before the first grid point. */
  Point lower = { { 0.0, 0.0, 0.0 } };
  /** The distance between neighbouring grid points along each axis. */
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

  /** The offset of a grid point in the order of the points, in which the first axis is the fastest. */
  std::size_t
  Offset(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return (static_cast<std::size_t>(z) * size[1] + y) * size[0] + x;
  }

  /** The offset of the grid point whose box holds the position, or of the nearest one. */
  std::size_t
  OffsetAt(const Point & position) const;
};

/** Makes the grid that fills the box with a whole number of points along each axis, about `step` apart. */
TissueGrid
MakeTissueGrid(const Box & box, double step);
} // namespace tissue

#endif
