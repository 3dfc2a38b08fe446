/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_DelaunayTetrahedralization_h
#define TissueTessellationCore_DelaunayTetrahedralization_h

#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
/** \brief The Delaunay tetrahedralization of the cell centres, closed by tetrahedra to the exterior vertex (paper,
 * sections 3.1 and 3.3), positively oriented: what AdjacencyComplex is made from.
 *
 * `centers[0]`, the exterior's, is ignored. Exact (CGAL); of cospherical points the choice is CGAL's symbolic
 * perturbation, so the result depends on the positions alone. Tetrahedra are ascending.
 * \throws std::invalid_argument for fewer than four cells, for two cells at the same place (named by their vertices),
 * and where all centres are coplanar. */
std::vector<VertexQuadruple>
DelaunayTetrahedralization(const std::vector<Point> & centers);
} // namespace tissue

#endif
