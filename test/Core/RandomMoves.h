/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef RandomMoves_h
#define RandomMoves_h

#include "Complex/AdjacencyComplex.h"
#include "Complex/LocalOperations.h"
#include "TissueTessellationCore/Common/Random.h"

namespace tissue_test
{
using namespace tissue;

inline TetrahedronId
RandomTetrahedron(const AdjacencyComplex & complex, Random & random)
{
  TetrahedronId id;
  do
  {
    id = static_cast<TetrahedronId>(random.Index(static_cast<std::size_t>(complex.TetrahedronIdBound())));
  } while (!complex.IsAlive(id));
  return id;
}

/** A triangle swap or an edge removal, each with probability 1/2, on a random element; legal or not. */
inline Proposal
RandomMove(const AdjacencyComplex & complex, const LocalOperations & operations, Random & random)
{
  const TetrahedronId id = RandomTetrahedron(complex, random);
  const auto          i = static_cast<int>(random.Index(4));
  if (random.Uniform() < 0.5)
  {
    return operations.SwapTriangle(id, i);
  }
  const VertexQuadruple & t = complex.GetTetrahedron(id).vertices;
  return operations.RemoveEdge({ { t[i], t[(i + 1 + random.Index(3)) % 4] } });
}

/** Makes a number of legal random moves. */
inline void
Scramble(AdjacencyComplex & complex, const LocalOperations & operations, int numberOfMoves, Random & random)
{
  for (int done = 0; done < numberOfMoves;)
  {
    if (const Proposal move = RandomMove(complex, operations, random))
    {
      complex.Apply(move.replacement);
      ++done;
    }
  }
}
} // namespace tissue_test

#endif
