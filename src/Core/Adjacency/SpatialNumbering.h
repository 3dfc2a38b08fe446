/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SpatialNumbering_h
#define TissueTessellationCore_SpatialNumbering_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <vector>

namespace tissue
{
/** \brief Other numbers for the vertices of a JunctionSet, along a curve through the tissue (SpatialOrder()): under
 * them, what is near in the tissue is near in memory. The exterior has number 0, and the voids come after the cells. */
struct SpatialNumbering
{
  /** The vertex of each number. */
  std::vector<VertexId> order;
  /** The number of each vertex. */
  std::vector<VertexId> ranks;
};

/** `centers` has a position for every vertex of the junctions. */
SpatialNumbering
NumberSpatially(const JunctionSet & junctions, const std::vector<Point> & centers);

/** The same junctions under the numbers; their cells are no longer in the order of the labels. */
JunctionSet
Renumbered(const JunctionSet & junctions, const SpatialNumbering & numbering);
} // namespace tissue

#endif
