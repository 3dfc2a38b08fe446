/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ReferenceAdjacency_h
#define TissueTessellationCore_ReferenceAdjacency_h

#include "Adjacency/QuadrupleSet.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <vector>

namespace tissue
{
/** \brief JunctionSet::votes to ask by quadruples. */
class JunctionVotes
{
public:
  /** \param votes each quadruple once, ascending within, in ascending order. */
  JunctionVotes(VertexId numberOfVertices, const std::vector<JunctionVote> & votes);

  bool
  IsEmpty() const
  {
    return m_Shares.empty();
  }

  /** Of a quadruple of vertices in any order; 0 where it has no vote. */
  double
  Share(const VertexQuadruple & vertices) const
  {
    const std::ptrdiff_t at = m_Quadruples.Find(vertices);
    return at == QuadrupleSet::NotFound ? 0.0 : m_Shares[static_cast<std::size_t>(at)];
  }

  /** All, in no special order. */
  std::vector<JunctionVote>
  List() const;

private:
  QuadrupleSet m_Quadruples;
  /** In the order of the set. */
  std::vector<double> m_Shares;
};

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
    return m_Smaller.Items().size();
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

  /** The row of a vertex holds the pairs of which it is the larger, by the other, ascending. */
  CompressedRows<VertexId> m_Smaller;
  QuadrupleSet             m_Quadruples;
  JunctionVotes            m_Votes;
};
} // namespace tissue

#endif
