/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Adjacency/JunctionVotes.h"

namespace tissue
{
namespace
{
std::vector<VertexQuadruple>
ListQuadruples(const std::vector<JunctionVote> & votes)
{
  std::vector<VertexQuadruple> quadruples;
  quadruples.reserve(votes.size());
  for (const JunctionVote & vote : votes)
  {
    quadruples.push_back(vote.cells);
  }
  return quadruples;
}
} // namespace

JunctionVotes::JunctionVotes(VertexId numberOfVertices, const std::vector<JunctionVote> & votes)
  : m_Quadruples(numberOfVertices, ListQuadruples(votes))
  , m_Shares(votes.size())
{
  for (const JunctionVote & vote : votes)
  {
    m_Shares[static_cast<std::size_t>(m_Quadruples.Find(vote.cells))] = vote.share;
  }
}

std::vector<JunctionVote>
JunctionVotes::List() const
{
  std::vector<JunctionVote> votes;
  votes.reserve(m_Shares.size());
  for (const VertexQuadruple & quadruple : m_Quadruples.List())
  {
    votes.push_back({ quadruple, m_Shares[votes.size()] });
  }
  return votes;
}
} // namespace tissue
