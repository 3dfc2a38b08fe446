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
AdjacencyOverlap
ComputeAdjacencyOverlap(const AdjacencyComplex & complex, const ReferenceAdjacency & reference)
{
  const auto edges = complex.GetEdges();
  const auto tetrahedra = complex.GetTetrahedra();
  const auto commonPairs = std::count_if(edges.begin(), edges.end(), [&](const AdjacencyComplex::Edge & edge) {
    return reference.HasPair(edge.vertices[0], edge.vertices[1]);
  });
  const auto commonQuadruples = std::count_if(
    tetrahedra.begin(), tetrahedra.end(), [&](const VertexQuadruple & t) { return reference.HasQuadruple(t); });
  return { Jaccard(static_cast<std::size_t>(commonPairs), edges.size(), reference.NumberOfPairs()),
           Jaccard(static_cast<std::size_t>(commonQuadruples), tetrahedra.size(), reference.NumberOfQuadruples()) };
}

AdjacencyOverlap
ComputeAdjacencyOverlap(std::vector<VertexQuadruple> tetrahedra, const std::vector<VertexId> & ids,
                        const JunctionSet & image)
{
  // Edges and tetrahedra become sets of ascending tuples, so that each counts once; then those are counted that are in
  // the image by their vertices' ids there.
  const ReferenceAdjacency reference(image);
  std::vector<VertexPair>  edges;
  for (VertexQuadruple & t : tetrahedra)
  {
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
  const auto isKnown = [&ids](VertexId v) { return ids[v] >= 0; };
  const auto commonPairs = std::count_if(edges.begin(), edges.end(), [&](const VertexPair & e) {
    return std::all_of(e.begin(), e.end(), isKnown) && reference.HasPair(ids[e[0]], ids[e[1]]);
  });
  const auto commonQuadruples = std::count_if(tetrahedra.begin(), tetrahedra.end(), [&](const VertexQuadruple & t) {
    return std::all_of(t.begin(), t.end(), isKnown) &&
           reference.HasQuadruple({ { ids[t[0]], ids[t[1]], ids[t[2]], ids[t[3]] } });
  });
  return { Jaccard(static_cast<std::size_t>(commonPairs), edges.size(), reference.NumberOfPairs()),
           Jaccard(static_cast<std::size_t>(commonQuadruples), tetrahedra.size(), reference.NumberOfQuadruples()) };
}
} // namespace tissue
