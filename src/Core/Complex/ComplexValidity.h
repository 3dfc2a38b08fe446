/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ComplexValidity_h
#define TissueTessellationCore_ComplexValidity_h

#include "Complex/AdjacencyComplex.h"

#include <string>
#include <vector>

namespace tissue
{
/** \brief Returns everything that is wrong with a complex, each violation as one sentence; nothing for a valid one.
 *
 * In a valid complex a tetrahedron has four different vertices, and no other has the same; neighbours are symmetric,
 * across the same triangle, with opposite orientations; every triangle is in exactly two tetrahedra; the records of
 * edges and of numbers of neighbours are right; every vertex is there, and its link is one 2-sphere; the complex is one
 * piece. All of this is checked from scratch. */
std::vector<std::string>
FindViolations(const AdjacencyComplex & complex);
} // namespace tissue

#endif
