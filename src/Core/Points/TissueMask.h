/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueMask_h
#define TissueTessellationCore_TissueMask_h

#include "Complex/AdjacencyComplex.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Points/TissueGrid.h"
#include "TissueTessellationCore/Tessellation/TissueSamples.h"

#include <cstdint>
#include <vector>

namespace tissue
{
/** The place of a tissue, by the points of a grid. */
struct TissueMask
{
  TissueGrid grid;
  /** 1 in the tissue, 0 outside. */
  std::vector<std::uint8_t> inside;
};

/** \brief Estimates where a tissue is from the centres of its cells alone.
 *
 * The tissue is all that lies within the tetrahedra of a cleaned complex, or nearer to its surface triangles than their
 * corners' depths. What this encloses on all sides belongs to it, what is outside of the box does not.
 *
 * \param complex the cells' complex, cleaned by CleanSurface().
 * \param depths how far each vertex is below the surface; 0 for those that are not at it (TissueSurface.h).
 * \param grid a grid that fills the box and is as fine as the mask is to be. */
TissueMask
EstimateTissueMask(const AdjacencyComplex & complex, const std::vector<Point> & centers,
                   const std::vector<double> & depths, const TissueGrid & grid,
                   const Execution & execution = Execution());

/** Gives the grid points in the tissue, in small groups. */
TissueSamples
SampleMask(const TissueMask & mask);
} // namespace tissue

#endif
