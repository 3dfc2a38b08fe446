/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueMask_h
#define TissueTessellationCore_TissueMask_h

#include "TissueTessellationCore/AdjacencyComplex.h"
#include "TissueTessellationCore/BoxGrid.h"
#include "TissueTessellationCore/ParallelFor.h"
#include "TissueTessellationCore/TissueSamples.h"

#include <cstdint>
#include <vector>

namespace tissue
{
/** \brief Where a tissue is, on a grid that fills a box. */
struct TissueMask
{
  std::array<std::int32_t, 3> size = { { 0, 0, 0 } };
  /** The corner of the box, half a step before the first grid point. */
  Point lower = { { 0.0, 0.0, 0.0 } };
  /** Between grid points along each axis. */
  Point steps = { { 1.0, 1.0, 1.0 } };
  /** 1 in the tissue, 0 outside; the first axis fastest. */
  std::vector<std::uint8_t> inside;

  Point
  Position(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return { { lower[0] + (x + 0.5) * steps[0], lower[1] + (y + 0.5) * steps[1], lower[2] + (z + 0.5) * steps[2] } };
  }

  std::size_t
  Offset(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return (static_cast<std::size_t>(z) * size[1] + y) * size[0] + x;
  }
};

/** How far the surface of the tissue is estimated to be from each cell centre at it; 0 for cells that are not.
 *
 * It is `fraction` times the median height of the centre above those of its neighbours below it, at most 0.6 of the
 * local spacing, evened out between neighbours. */
std::vector<double>
EstimateSurfaceDepths(const AdjacencyComplex & complex, const std::vector<Point> & centers,
                      const std::vector<double> & spacings, double fraction);

/** \brief Estimates where a tissue is from the centres of its cells alone.
 *
 * It is what lies within the tetrahedra of a cleaned complex, or nearer to its surface triangles than their corners'
 * depths; what this encloses on all sides belongs to it, what is outside of the box does not.
 *
 * \param complex cleaned (CleanSurface()).
 * \param depths a length a vertex, of those at the surface (EstimateSurfaceDepths()).
 * \param step about the distance of grid points, which is such that a whole number of them fills the box. */
TissueMask
EstimateTissueMask(const AdjacencyComplex & complex, const std::vector<Point> & centers,
                   const std::vector<double> & depths, const Box & box, double step,
                   const ParallelFor & parallelFor = ParallelFor());

/** The grid points in the tissue, in small groups. */
TissueSamples
SampleMask(const TissueMask & mask);
} // namespace tissue

#endif
