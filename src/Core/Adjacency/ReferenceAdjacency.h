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
/** \brief The votes of JunctionSet::votes, to be looked up by quadruples. */
class JunctionVotes
{
public:
  /** \param votes in ascending order of their quadruples, each of which is there once, with its vertices ascending. */
  JunctionVotes(VertexId numberOfVertices, const std::vector<JunctionVote> & votes);

  bool
  IsEmpty() const
  {
    return m_Shares.empty();
  }

  /** Returns the share of the votes that a quadruple has, its vertices in any order; 0 where it has none. */
  double
  Share(const VertexQuadruple & vertices) const
  {
    const std::ptrdiff_t at = m_Quadruples.Find(vertices);
    return at == QuadrupleSet::NotFound ? 0.0 : m_Shares[static_cast<std::size_t>(at)];
  }

  /** Returns all votes, in no special order. */
  std::vector<JunctionVote>
  List() const;

private:
  QuadrupleSet m_Quadruples;
  /** The shares of the quadruples, in the order of the set. */
  std::vector<double> m_Shares;
};

/** \brief The adjacencies that an image shows, as sets that can be asked for members: E_S, the pairs of cells that
 * share a wall, and T_S, the quadruples of cells that meet at a point (paper, sections 3.4 and 4.1). The exterior
 * counts as a cell. */
class ReferenceAdjacency
{
public:
  /** \throws std::invalid_argument for more than 2 097 151 cells: ids are kept in 21 bits. */
  explicit ReferenceAdjacency(const JunctionSet & junctions);

  /** Returns the same adjacencies with each vertex v called ids[v]; `ids` is a permutation. */
  ReferenceAdjacency
  Renumbered(const std::vector<VertexId> & ids) const;

  /** Whether the image shows a wall of the two. */
  bool
  HasPair(VertexId u, VertexId v) const;

  /** Whether the image shows walls of all six pairs of the four. */
  bool
  AreNeighbors(const VertexQuadruple & vertices) const;

  /** Whether the image shows that the four meet; the vertices are in any order. */
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

  /** Tells how sure it is that the four meet, in 0 .. 1: the share of the votes, or, in a reference without votes, 1
   * for its quadruples and 0 for all others. The vertices are in any order. */
  double
  Certainty(const VertexQuadruple & vertices) const
  {
    return this->HasVotes() ? m_Votes.Share(vertices) : this->HasQuadruple(vertices) ? 1.0 : 0.0;
  }

  /** Returns all pairs, the smaller vertex of each first. */
  std::vector<VertexPair>
  GetPairs() const;

  /** Returns all quadruples, each with its vertices ascending. */
  std::vector<VertexQuadruple>
  GetQuadruples() const
  {
    return m_Quadruples.List();
  }

  VertexId
  NumberOfVertices() const
  {
    return static_cast<VertexId>(m_Smaller.NumberOfRows());
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
  /** Takes tuples whose vertices ascend, in ascending order. */
  ReferenceAdjacency(VertexId numberOfVertices, const std::vector<VertexPair> & pairs,
                     const std::vector<VertexQuadruple> & quadruples, const std::vector<JunctionVote> & votes);

  /** The row of a vertex holds the smaller vertices of the pairs in which it is the larger one, ascending. */
  CompressedRows<VertexId> m_Smaller;
  QuadrupleSet             m_Quadruples;
  JunctionVotes            m_Votes;
};
} // namespace tissue

#endif
