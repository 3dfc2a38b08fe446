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
/** The transform g of the paper (section 4.2) for a tetrahedron: the circumcentre; where that lies outside, the
 * circumcentre of the closest triangle; where that lies outside the triangle, the middle of the closest edge. Inside
 * the tetrahedron, or on it, always. The barycentre for a flat tetrahedron, which has no circumcentre. */
Point
ProjectedCircumcenter(const std::array<Point, 4> & tetrahedron);

/** Likewise for a triangle, which stands for a tetrahedron with the exterior (section 4.2). */
Point
ProjectedCircumcenter(const std::array<Point, 3> & triangle);

/** \brief The position of the cell corner dual to each tetrahedron, in the order of AdjacencyComplex::GetTetrahedra().
 *
 * Corners that fall on the same place are moved apart, by a twentieth of the way to the mean of their cells' centres.
 * `junctions` gives the centres of the cells and, for CornerRule::ImageJunction, the junctions. */
std::vector<Point>
ComputeCorners(const AdjacencyComplex & complex, const JunctionSet & junctions, CornerRule rule);
} // namespace tissue

#endif
