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
namespace
{
template <typename TTuple, typename TTest>
std::size_t
CountIf(const std::vector<TTuple> & tuples, const TTest & test)
{
  return static_cast<std::size_t>(std::count_if(tuples.begin(), tuples.end(), test));
}

/** Whether test(u, v) holds of all six pairs of the four. */
template <typename TTest>
bool
AllOfPairs(const VertexQuadruple & q, const TTest & test)
{
  return test(q[0], q[1]) && test(q[0], q[2]) && test(q[0], q[3]) && test(q[1], q[2]) && test(q[1], q[3]) &&
         test(q[2], q[3]);
}
} // namespace

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
  const auto isKnown = [&](const auto & tuple) {
    return std::all_of(tuple.begin(), tuple.end(), [&](VertexId v) { return v < reference.NumberOfVertices(); });
  };
  const std::size_t commonPairs = CountIf(
    tuples.pairs, [&](const VertexPair & pair) { return isKnown(pair) && reference.HasPair(pair[0], pair[1]); });
  const auto isCommon = [&](const VertexQuadruple & q) { return isKnown(q) && reference.HasQuadruple(q); };
  const auto areNeighbors = [&](const VertexQuadruple & q) {
    return AllOfPairs(q, [&](VertexId u, VertexId v) { return tuples.HasPair(u, v); });
  };
  const auto areNeighborsInImage = [&](const VertexQuadruple & q) { return reference.AreNeighbors(q); };

  AdjacencyOverlap overlap;
  overlap.adjacency2 = Jaccard(commonPairs, tuples.pairs.size(), reference.NumberOfPairs());
  overlap.adjacency4 =
    Jaccard(CountIf(tuples.quadruples, isCommon), tuples.quadruples.size(), reference.NumberOfQuadruples());
  overlap.adjacency4OfNeighbors = Jaccard(
    CountIf(tuples.quadruples,
            [&](const VertexQuadruple & q) { return isCommon(q) && areNeighbors(q) && areNeighborsInImage(q); }),
    CountIf(tuples.quadruples, areNeighbors),
    CountIf(reference.GetQuadruples(), areNeighborsInImage));
  overlap.numberOfFalsePairs = tuples.pairs.size() - commonPairs;
  overlap.numberOfMissingPairs = reference.NumberOfPairs() - commonPairs;
  return overlap;
}

AdjacencyOverlap
ComputeAdjacencyOverlap(const AdjacencyTuples & tuples, const std::vector<VertexId> & ids, const JunctionSet & image)
{
  // A vertex that is not in the image gets an id above those of the image.
  const ReferenceAdjacency reference(image);
  AdjacencyTuples          ofImage = tuples;
  const auto               rename = [&](auto & list) {
    for (auto & tuple : list)
    {
      for (VertexId & v : tuple)
      {
        v = ids[v] >= 0 ? ids[v] : reference.NumberOfVertices() + v;
      }
      std::sort(tuple.begin(), tuple.end());
    }
    SortUnique(list);
  };
  rename(ofImage.pairs);
  rename(ofImage.quadruples);
  return ComputeAdjacencyOverlap(ofImage, reference);
}
} // namespace tissue
