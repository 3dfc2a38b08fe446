/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SurfaceLift_h
#define TissueTessellationCore_SurfaceLift_h

#include "Complex/AdjacencyComplex.h"

#include <vector>

namespace tissue
{
/** \brief Moves the corners at the exterior out to where the surface of the tissue is.
 *
 * The paper puts them between the centres of their three cells (section 4.2), half a cell below the surface. Here each
 * is moved along the mean outward normal of its cells by the mean of their depths. A cell's depth, from its centre to
 * the surface, is taken to be half the median height of its centre above those of its neighbours below it, as if the
 * cell were as thick above as it is below. For a cell that has no neighbour below, it is half the median distance of
 * its neighbours.
 *
 * \param centers the centres of the vertices; the exterior's is ignored.
 * \param corners the corners, in the order of AdjacencyComplex::GetTetrahedra(). */
void
LiftSurfaceCorners(const AdjacencyComplex & complex, const std::vector<Point> & centers, std::vector<Point> & corners);
} // namespace tissue

#endif
