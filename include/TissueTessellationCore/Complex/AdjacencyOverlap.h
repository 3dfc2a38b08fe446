/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_AdjacencyOverlap_h
#define TissueTessellationCore_AdjacencyOverlap_h

#include "TissueTessellationCore/Common/Types.h"

#include <cstddef>
#include <vector>

namespace tissue
{
class ReferenceAdjacency;
struct JunctionSet;

/** Jaccard indices of the complex and an image (paper, section 4.1). */
struct AdjacencyOverlap
{
  /** |E_T & E_S| / |E_T | E_S|, in 0 .. 1. */
  double adjacency2 = 0.0;
  /** |T_T & T_S| / |T_T | T_S|, in 0 .. 1. */
  double adjacency4 = 0.0;
  /** The same of those quadruples alone whose six pairs are neighbours, where each side goes by its own pairs: in E_S
   * for the image, in E_T for the complex, which has no others. A block of more than four cells holds quadruples with a
   * pair that shares no face; adjacency4 asks for them, each at the price of a false pair. */
  double adjacency4OfNeighbors = 0.0;
  /** |E_T - E_S| and |E_S - E_T|. */
  std::size_t numberOfFalsePairs = 0;
  std::size_t numberOfMissingPairs = 0;
};

/** \brief What cells a complex or a mesh says to touch: pairs and quadruples, each once, their vertices ascending, and
 * all in ascending order. */
struct AdjacencyTuples
{
  std::vector<VertexPair>      pairs;
  std::vector<VertexQuadruple> quadruples;

  /** Of tetrahedra, in any order, which may repeat each other, and walls beside theirs. */
  static AdjacencyTuples
  Of(std::vector<VertexQuadruple> tetrahedra, std::vector<VertexPair> walls = {});

  bool
  HasPair(VertexId u, VertexId v) const;
};

/** Returns |A & B| / |A | B| from the sizes of A & B, A and B; 0 where both sets are empty. */
inline double
Jaccard(std::size_t common, std::size_t first, std::size_t second)
{
  const std::size_t all = first + second - common;
  return all > 0 ? static_cast<double>(common) / static_cast<double>(all) : 0.0;
}

/** Compares a complex, or a mesh, with a reference. A tuple with a vertex that the reference has not is in the one set
 * alone. */
AdjacencyOverlap
ComputeAdjacencyOverlap(const AdjacencyTuples & tuples, const ReferenceAdjacency & reference);

/** Compares a complex over vertices of its own with the junctions of an image: its vertex v is ids[v] in the image, or
 * not known there where that is negative. Tuples with unknown vertices count as wrong. */
AdjacencyOverlap
ComputeAdjacencyOverlap(const AdjacencyTuples & tuples, const std::vector<VertexId> & ids, const JunctionSet & image);
} // namespace tissue

#endif
