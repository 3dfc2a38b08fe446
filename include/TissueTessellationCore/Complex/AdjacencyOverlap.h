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
class AdjacencyComplex;
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

/** Returns |A & B| / |A | B| from the sizes of A & B, A and B; 0 where both sets are empty. */
inline double
Jaccard(std::size_t common, std::size_t first, std::size_t second)
{
  const std::size_t all = first + second - common;
  return all > 0 ? static_cast<double>(common) / static_cast<double>(all) : 0.0;
}

/** \brief Compares sets of pairs and quadruples with a reference: each tuple is there once.
 *
 * `quadruplesOfNeighbors` are those of the quadruples whose six pairs are among the pairs. A tuple with a vertex that
 * the reference has not is in the one set alone. */
AdjacencyOverlap
ComputeAdjacencyOverlap(const std::vector<VertexPair> & pairs, const std::vector<VertexQuadruple> & quadruples,
                        const std::vector<VertexQuadruple> & quadruplesOfNeighbors,
                        const ReferenceAdjacency &           reference);

/** Compares a complex with a reference that has the same vertices. */
AdjacencyOverlap
ComputeAdjacencyOverlap(const AdjacencyComplex & complex, const ReferenceAdjacency & reference);

/** Compares tetrahedra over vertices of their own with the junctions of an image: their vertex v is ids[v] in the
 * image, or is not there where that is negative. */
AdjacencyOverlap
ComputeAdjacencyOverlap(std::vector<VertexQuadruple> tetrahedra, const std::vector<VertexId> & ids,
                        const JunctionSet & image);
} // namespace tissue

#endif
