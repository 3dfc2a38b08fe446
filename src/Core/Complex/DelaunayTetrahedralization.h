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
/** \brief Returns the Delaunay tetrahedralization of the cell centres, closed by tetrahedra to the exterior vertex
 * (paper, sections 3.1 and 3.3): the positively oriented tetrahedra that an AdjacencyComplex is made from, ascending.
 *
 * `centers[0]`, the exterior's, is ignored. The result is exact (CGAL). Among cospherical points CGAL's symbolic
 * perturbation decides, so that the result depends on the positions alone.
 * \throws std::invalid_argument for fewer than four cells, for two cells at the same place (named by their vertices),
 * and where all centres are coplanar. */
std::vector<VertexQuadruple>
DelaunayTetrahedralization(const std::vector<Point> & centers);
} // namespace tissue

#endif
