/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SurfaceHeights_h
#define TissueTessellationCore_SurfaceHeights_h

#include "Complex/AdjacencyComplex.h"

#include <vector>

namespace tissue
{
/** \brief By vertices at the surface, the heights of their centres above those of their neighbours below: twice the
 * depth of their cells, about.
 *
 * \param normals out of the tissue, of unit length, by vertices; zero of those that are not at the surface, which have
 * no heights. */
std::vector<std::vector<double>>
CollectHeights(const AdjacencyComplex & complex, const std::vector<Point> & centers,
               const std::vector<Point> & normals);
} // namespace tissue

#endif
