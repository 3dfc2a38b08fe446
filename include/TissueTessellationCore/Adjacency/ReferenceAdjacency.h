/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ReferenceAdjacency_h
#define TissueTessellationCore_ReferenceAdjacency_h

#include "TissueTessellationCore/Complex/AdjacencyComplex.h"
#include "TissueTessellationCore/Adjacency/JunctionVotes.h"

#include <vector>

namespace tissue
{
/** \brief The adjacencies that an image shows, as sets to ask: E_S, the pairs of cells that share a wall, and T_S, the
 * quadruples of cells that meet at a point (paper, sections 3.4 and 4.1). The exterior counts as a cell. */
class ReferenceAdjacency
{
public:
  /** \throws std::invalid_argument for more than 2 097 151 cells: ids are kept in 21 bits. */
  explicit ReferenceAdjacency(const JunctionSet & junctions);

  /** The same adjacencies of vertices by new ids: ids[v], a permutation, for v. */
  ReferenceAdjacency
  Renumbered(const std::vector<VertexId> & ids) const;

  bool
  HasPair(VertexId u, VertexId v) const;

  /** Vertices in any order. */
  bool
  HasQuadruple(const VertexQuadruple & vertices) const
  {
    return m_Quadruples.Find(vertices) != QuadrupleSet::NotFound;
  }

  /** Whether the quadruples are estimates, with votes on each (JunctionSet::votes). */
  bool
  HasVotes() const
  {
    return !m_Votes.IsEmpty();
  }

  /** How sure it is that the four meet, in 0 .. 1: the share of the votes, and where there are none, 1 for the
   * quadruples of the reference and 0 for others. Vertices in any order. */
  double
  Certainty(const VertexQuadruple & vertices) const
  {
    return this->HasVotes() ? m_Votes.Share(vertices) : this->HasQuadruple(vertices) ? 1.0 : 0.0;
  }

  /** All pairs, ascending within each. */
  std::vector<VertexPair>
  GetPairs() const;

  /** All quadruples, ascending within each. */
  std::vector<VertexQuadruple>
  GetQuadruples() const
  {
    return m_Quadruples.List();
  }

  std::size_t
  NumberOfPairs() const
  {
    return m_Smaller.size();
  }

  std::size_t
  NumberOfQuadruples() const
  {
    return m_Quadruples.Size();
  }

private:
  /** Of tuples that ascend, each within, and all of them by the smaller ones of each. */
  ReferenceAdjacency(VertexId numberOfVertices, const std::vector<VertexPair> & pairs,
                     const std::vector<VertexQuadruple> & quadruples, const std::vector<JunctionVote> & votes);

  /** Compressed rows: the row of a vertex holds the pairs of which it is the larger, by the other, ascending. */
  std::vector<std::size_t> m_PairRows;
  std::vector<VertexId>    m_Smaller;
  QuadrupleSet             m_Quadruples;
  JunctionVotes            m_Votes;
};

/** Jaccard indices of the complex and an image (paper, section 4.1). */
struct AdjacencyOverlap
{
  /** |E_T & E_S| / |E_T | E_S|, in 0 .. 1. */
  double adjacency2 = 0.0;
  /** |T_T & T_S| / |T_T | T_S|, in 0 .. 1. */
  double adjacency4 = 0.0;
};

AdjacencyOverlap
ComputeAdjacencyOverlap(const AdjacencyComplex & complex, const ReferenceAdjacency & reference);

/** Likewise of tetrahedra over vertices of their own: ids[v] is what v is in the reference, negative where it is
 * nothing there. */
AdjacencyOverlap
ComputeAdjacencyOverlap(std::vector<VertexQuadruple> tetrahedra, const std::vector<VertexId> & ids,
                        const ReferenceAdjacency & reference);

/** |A & B| / |A | B| from the sizes of A, B and A & B; 0 where both sets are empty. */
inline double
Jaccard(std::size_t common, std::size_t first, std::size_t second)
{
  const std::size_t all = first + second - common;
  return all > 0 ? static_cast<double>(common) / static_cast<double>(all) : 0.0;
}
} // namespace tissue

#endif
