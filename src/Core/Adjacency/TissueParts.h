/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueParts_h
#define TissueTessellationCore_TissueParts_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <vector>

namespace tissue
{
/** \brief The parts of a tissue that touch each other in the exterior alone.
 *
 * Each part has a complex of its own, closed by the exterior: one complex of all parts would need walls that are not
 * there. */
struct TissueParts
{
  /** For each part, its cells, ascending, then its voids. The largest part comes first, and of equal ones that with the
   * smallest label. A void is in the part with which it has most junctions, which is the one that encloses it where the
   * void holds other parts. */
  std::vector<std::vector<VertexId>> parts;
  /** The cells of parts that are too small for a complex (fewer than four cells, or centres in one plane), ascending.
   * Each was added to the part of the cell nearest to it. */
  std::vector<VertexId> strayCells;

  /** Returns the index of the part of each vertex, which is -1 for the exterior. */
  std::vector<int>
  PartOfVertex(VertexId numberOfVertices) const;
};

/** Finds the parts, which are what junctions connect. `centers` has a position for every vertex of `junctions`. A
 * tissue that has no part large enough is one part. */
TissueParts
FindTissueParts(const JunctionSet & junctions, const std::vector<Point> & centers);

/** Returns all cells and voids as one part. */
TissueParts
JoinTissueParts(const JunctionSet & junctions);
} // namespace tissue

#endif
