/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"

#include "Adjacency/ReferenceAdjacency.h"
#include "Common/Algorithms.h"

#include <algorithm>

namespace tissue
{
AdjacencyTuples
AdjacencyTuples::Of(std::vector<VertexQuadruple> tetrahedra, std::vector<VertexPair> walls)
{
  AdjacencyTuples tuples{ std::move(walls), std::move(tetrahedra) };
  for (VertexPair & pair : tuples.pairs)
  {
    std::sort(pair.begin(), pair.end());
  }
  for (VertexQuadruple & t : tuples.quadruples)
  {
    std::sort(t.begin(), t.end());
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        tuples.pairs.push_back({ { t[i], t[j] } });
      }
    }
  }
  SortUnique(tuples.pairs);
  SortUnique(tuples.quadruples);
  return tuples;
}

bool
AdjacencyTuples::HasPair(VertexId u, VertexId v) const
{
  return std::binary_search(pairs.begin(), pairs.end(), VertexPair{ { std::min(u, v), std::max(u, v) } });
}

AdjacencyOverlap
ComputeAdjacencyOverlap(const AdjacencyTuples & tuples, const ReferenceAdjacency & reference)
{
  const auto commonPairs = std::count_if(tuples.pairs.begin(), tuples.pairs.end(), [&](const VertexPair & pair) {
    return reference.HasPair(pair[0], pair[1]);
  });
  const auto commonQuadruples =
    std::count_if(tuples.quadruples.begin(), tuples.quadruples.end(), [&](const VertexQuadruple & q) {
      return reference.HasQuadruple(q);
    });
  return {
    Jaccard(static_cast<std::size_t>(commonPairs), tuples.pairs.size(), reference.NumberOfPairs()),
    Jaccard(static_cast<std::size_t>(commonQuadruples), tuples.quadruples.size(), reference.NumberOfQuadruples())
  };
}

AdjacencyOverlap
ComputeAdjacencyOverlap(const AdjacencyTuples & tuples, const std::vector<VertexId> & ids, const JunctionSet & image)
{
  const ReferenceAdjacency reference(image);
  const auto               isKnown = [&ids](VertexId v) { return ids[v] >= 0; };
  const auto commonPairs = std::count_if(tuples.pairs.begin(), tuples.pairs.end(), [&](const VertexPair & pair) {
    return std::all_of(pair.begin(), pair.end(), isKnown) && reference.HasPair(ids[pair[0]], ids[pair[1]]);
  });
  const auto commonQuadruples =
    std::count_if(tuples.quadruples.begin(), tuples.quadruples.end(), [&](const VertexQuadruple & q) {
      return std::all_of(q.begin(), q.end(), isKnown) &&
             reference.HasQuadruple({ { ids[q[0]], ids[q[1]], ids[q[2]], ids[q[3]] } });
    });
  return {
    Jaccard(static_cast<std::size_t>(commonPairs), tuples.pairs.size(), reference.NumberOfPairs()),
    Jaccard(static_cast<std::size_t>(commonQuadruples), tuples.quadruples.size(), reference.NumberOfQuadruples())
  };
}
} // namespace tissue
