/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_JunctionVotes_h
#define TissueTessellationCore_JunctionVotes_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Adjacency/QuadrupleSet.h"

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
} // namespace tissue

#endif
