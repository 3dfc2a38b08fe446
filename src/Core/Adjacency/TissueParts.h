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
 * Each part has a complex of its own, closed by the exterior; joined in one they would need walls that are not there.
 */
struct TissueParts
{
  /** The cells of each part, ascending, then its voids; the largest part first, of equal ones that with the smallest
   * label. A void is in the part with which it has most junctions: the one that encloses it, where it holds others. */
  std::vector<std::vector<VertexId>> parts;
  /** Cells of parts too small for a complex (fewer than four cells, or centres in one plane), which were counted to the
   * part of the nearest cell; ascending. */
  std::vector<VertexId> strayCells;

  /** The index of the part of each vertex; -1 for the exterior. */
  std::vector<int>
  PartOfVertex(VertexId numberOfVertices) const;
};

/** Parts are connected by junctions. `centers` has a position for every vertex of `junctions`. A tissue that has no
 * part large enough is one part. */
TissueParts
FindTissueParts(const JunctionSet & junctions, const std::vector<Point> & centers);

/** All cells as one part. */
TissueParts
JoinTissueParts(const JunctionSet & junctions);
} // namespace tissue

#endif
