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
/** \brief Everything that is wrong with a complex, each violation as one sentence; empty for a valid one.
 *
 * Checked from scratch: four different vertices a tetrahedron; neighbours symmetric and across the same triangle, with
 * opposite orientations; no two tetrahedra with the same vertices, every triangle in exactly two; the records of edges
 * and of numbers of neighbours; every vertex present and its link one 2-sphere; the complex one piece. Where parts of
 * the tissue touch in the exterior alone, the exterior's link is one sphere for each of them. */
std::vector<std::string>
FindViolations(const AdjacencyComplex & complex, std::size_t numberOfParts = 1);
} // namespace tissue

#endif
