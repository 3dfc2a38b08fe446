/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_VertexRelocation_h
#define TissueTessellationCore_VertexRelocation_h

#include "TissueTessellationCore/Optimization/AnnealingState.h"
#include "TissueTessellationCore/Common/Progress.h"

namespace tissue
{
struct VertexRelocationParameters
{
  /** A vertex is tried where its quadruples that are missing and its tetrahedra that are not in the reference are more
   * than this share of its quadruples in the reference; 0 or more. */
  double wrongShare = 0.25;
  /** At most this share of all vertices is tried, the worst first: where more are wrong, the rest of the complex is no
   * help to place them by. */
  double largestShare = 0.2;
  /** Places that are tried for a vertex, the most promising first. */
  int numberOfPlaces = 2;
  /** Rounds of annealing around the vertex at its new place, and proposals in each for each tetrahedron there. */
  int    numberOfRounds = 10;
  int    proposalsPerTetrahedron = 40;
  double initialTemperature = 0.5;
  double finalTemperature = 0.08;
};

/** \brief Takes vertices out of the complex where they are at the wrong place, and puts them in at a better one.
 *
 * The centre of a large or bent cell may lie far from its walls, so that Delaunay puts its vertex among the wrong
 * cells. No chain of swaps and removals leads away from there without tearing up all that lies between. Here the vertex
 * is reduced to four neighbours and taken out, and inserted into a tetrahedron that is not in the reference and whose
 * vertices are the cell's neighbours there (the hole that the missing cell left); then the complex is annealed around
 * it. What does not lower the energy is undone. Returns the number of vertices that found a better place.
 *
 * Requires a reference and combinatorial legality. `oneQuadruple` is the energy that temperatures are measured in. */
std::size_t
RelocateVertices(AnnealingState & state, const VertexRelocationParameters & parameters, double oneQuadruple,
                 const ProgressFunction & progress = ProgressFunction());
} // namespace tissue

#endif
