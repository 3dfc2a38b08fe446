/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CellCorners_h
#define TissueTessellationCore_CellCorners_h

#include "Complex/AdjacencyComplex.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Dual/CornerRule.h"

#include <vector>

namespace tissue
{
/** Returns the transform g of the paper (section 4.2) for a tetrahedron: the circumcentre; where that lies outside, the
 * circumcentre of the closest triangle; where that lies outside the triangle, the middle of its closest edge. The
 * result always lies inside the tetrahedron or on it. For a flat one, which has no circumcentre, it is the barycentre.
 */
Point
ProjectedCircumcenter(const std::array<Point, 4> & tetrahedron);

/** Returns the transform g for a triangle, which stands for a tetrahedron with the exterior (paper, section 4.2): the
 * circumcentre, or, where that lies outside, the middle of the closest edge. */
Point
ProjectedCircumcenter(const std::array<Point, 3> & triangle);

/** \brief Returns the position of the cell corner that is dual to each tetrahedron, in the order of
 * AdjacencyComplex::GetTetrahedra().
 *
 * Corners that fall on the same place are moved apart, each by a twentieth of the way to the mean of its cells'
 * centres. `junctions` gives the centres of the cells and, for CornerRule::ImageJunction, the junctions. */
std::vector<Point>
ComputeCorners(const AdjacencyComplex & complex, const JunctionSet & junctions, CornerRule rule);
} // namespace tissue

#endif
