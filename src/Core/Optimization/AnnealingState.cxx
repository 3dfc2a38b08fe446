/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Optimization/AnnealingState.h"

#include "Common/Algorithms.h"

#include <algorithm>

namespace tissue
{
std::vector<TetrahedronId>
AnnealingState::WrongAndNeighbors(const std::vector<TetrahedronId> & tetrahedra) const
{
  // A share of the votes: a tetrahedron with less counts as wrong. A larger one gives longer lists, a smaller one
  // leaves doubtful tetrahedra alone. Without votes, where certainties are 0 and 1, any share between gives the same.
  constexpr double           leastCertainty = 0.8;
  std::vector<TetrahedronId> list;
  for (const TetrahedronId id : tetrahedra)
  {
    const AdjacencyComplex::Tetrahedron & tetrahedron = complex.GetTetrahedron(id);
    if (energy.GetReference()->Certainty(tetrahedron.vertices) < leastCertainty)
    {
      list.push_back(id);
      list.insert(list.end(), tetrahedron.neighbors.begin(), tetrahedron.neighbors.end());
    }
  }
  SortUnique(list);
  return list;
}

Proposal
AnnealingState::RemoveEdgeByReference(VertexPair edge) const
{
  const ReferenceAdjacency & reference = *energy.GetReference();
  return operations.RemoveEdge(edge, [&](const AdjacencyComplex::Ring & ring, int i, int j, int k) {
    const VertexId a = ring.vertices[i];
    const VertexId b = ring.vertices[j];
    const VertexId c = ring.vertices[k];
    // The triangle makes two tetrahedra, one with each end of the edge: its cost is what they lack of being certain.
    return 2.0 - reference.Certainty({ { edge[0], a, b, c } }) - reference.Certainty({ { edge[1], a, b, c } });
  });
}

Proposal
AnnealingState::ProposeAt(TetrahedronId id, std::int32_t maximumDegree)
{
  // Shares of the proposals. With six edges and four triangles each element of a tetrahedron is proposed as often. Half
  // of the rings are triangulated at random, which leads out of local minima, half by the reference, which gains more.
  constexpr double        removalShare = 0.6;
  constexpr double        randomRingShare = 0.5;
  constexpr int           edges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
  const VertexQuadruple & vertices = complex.GetTetrahedron(id).vertices;
  if (random.Uniform() >= removalShare)
  {
    return operations.SwapTriangle(id, static_cast<int>(random.Index(4)));
  }
  const auto &     e = edges[random.Index(6)];
  const VertexPair edge{ { vertices[e[0]], vertices[e[1]] } };
  if (complex.FindEdge(edge[0], edge[1])->degree > maximumDegree)
  {
    return { Verdict::DegreeAboveLimit, {} };
  }
  if (random.Uniform() >= randomRingShare)
  {
    return this->RemoveEdgeByReference(edge);
  }
  return operations.RemoveEdge(edge,
                               [this](const AdjacencyComplex::Ring &, int, int, int) { return random.Uniform(); });
}
} // namespace tissue
