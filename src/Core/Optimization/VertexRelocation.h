/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_VertexRelocation_h
#define TissueTessellationCore_VertexRelocation_h

#include "Optimization/AnnealingState.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Optimization/OptimizationParameters.h"

namespace tissue
{

/** \brief Takes vertices out of the complex where they are at the wrong place, and puts them in at a better one.
 *
 * The centre of a large or bent cell may lie far from its walls, so that Delaunay puts its vertex among the wrong
 * cells. No chain of swaps and removals leads away from there without tearing up all that lies between. Here the vertex
 * is reduced to four neighbours and taken out. It is inserted into a tetrahedron that is not in the reference and whose
 * vertices are the cell's neighbours there, the hole that the missing cell left; then the complex is annealed around
 * it. What does not lower the energy is undone. Returns the number of vertices that found a better place.
 *
 * There must be a reference, and legality must be combinatorial. `oneQuadruple` is the energy that temperatures are
 * measured in. */
std::size_t
RelocateVertices(AnnealingState & state, const VertexRelocationParameters & parameters, double oneQuadruple,
                 const Execution & execution = Execution());
} // namespace tissue

#endif
