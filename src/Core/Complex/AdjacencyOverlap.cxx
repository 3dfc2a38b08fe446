/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"

#include "Adjacency/ReferenceAdjacency.h"
#include "Common/Algorithms.h"
#include "Complex/AdjacencyComplex.h"

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
} // namespace

AdjacencyOverlap
ComputeAdjacencyOverlap(const std::vector<VertexPair> & pairs, const std::vector<VertexQuadruple> & quadruples,
                        const std::vector<VertexQuadruple> & quadruplesOfNeighbors,
                        const ReferenceAdjacency &           reference)
{
  const auto isKnown = [&](const auto & tuple) {
    return std::all_of(tuple.begin(), tuple.end(), [&](VertexId v) { return v < reference.NumberOfVertices(); });
  };
  const std::size_t commonPairs =
    CountIf(pairs, [&](const VertexPair & pair) { return isKnown(pair) && reference.HasPair(pair[0], pair[1]); });
  const auto isCommon = [&](const VertexQuadruple & q) { return isKnown(q) && reference.HasQuadruple(q); };
  const auto areNeighbors = [&](const VertexQuadruple & q) { return reference.AreNeighbors(q); };

  AdjacencyOverlap overlap;
  overlap.adjacency2 = Jaccard(commonPairs, pairs.size(), reference.NumberOfPairs());
  overlap.adjacency4 = Jaccard(CountIf(quadruples, isCommon), quadruples.size(), reference.NumberOfQuadruples());
  overlap.adjacency4OfNeighbors =
    Jaccard(CountIf(quadruplesOfNeighbors, [&](const VertexQuadruple & q) { return isCommon(q) && areNeighbors(q); }),
            quadruplesOfNeighbors.size(),
            CountIf(reference.GetQuadruples(), areNeighbors));
  overlap.numberOfFalsePairs = pairs.size() - commonPairs;
  overlap.numberOfMissingPairs = reference.NumberOfPairs() - commonPairs;
  return overlap;
}

AdjacencyOverlap
ComputeAdjacencyOverlap(const AdjacencyComplex & complex, const ReferenceAdjacency & reference)
{
  std::vector<VertexPair> edges;
  for (const AdjacencyComplex::Edge & edge : complex.GetEdges())
  {
    edges.push_back(edge.vertices);
  }
  const std::vector<VertexQuadruple> tetrahedra = complex.GetTetrahedra();
  return ComputeAdjacencyOverlap(edges, tetrahedra, tetrahedra, reference);
}

AdjacencyOverlap
ComputeAdjacencyOverlap(std::vector<VertexQuadruple> tetrahedra, const std::vector<VertexId> & ids,
                        const JunctionSet & image)
{
  // A vertex that is not in the image gets an id above those of the image.
  const ReferenceAdjacency reference(image);
  std::vector<VertexPair>  edges;
  for (VertexQuadruple & t : tetrahedra)
  {
    for (VertexId & v : t)
    {
      v = ids[v] >= 0 ? ids[v] : reference.NumberOfVertices() + v;
    }
    std::sort(t.begin(), t.end());
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        edges.push_back({ { t[i], t[j] } });
      }
    }
  }
  SortUnique(tetrahedra);
  SortUnique(edges);
  return ComputeAdjacencyOverlap(edges, tetrahedra, tetrahedra, reference);
}
} // namespace tissue
