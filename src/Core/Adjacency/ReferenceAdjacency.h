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
                     const std::vector<VertexQuadruple> & quadruples);

  /** The row of a vertex holds the smaller vertices of the pairs in which it is the larger one, ascending. */
  CompressedRows<VertexId> m_Smaller;
  QuadrupleSet             m_Quadruples;
};
} // namespace tissue

#endif
