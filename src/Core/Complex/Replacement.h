/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Replacement_h
#define TissueTessellationCore_Replacement_h

#include "TissueTessellationCore/Common/Types.h"

#include <boost/container/small_vector.hpp>

namespace tissue
{
/** Index of a tetrahedron of an AdjacencyComplex; given anew once its tetrahedron is gone. */
using TetrahedronId = std::int32_t;

/** \brief A local change of the adjacency complex, as a value: tetrahedra out, tetrahedra in.
 *
 * Proposed by a pure function (LocalOperations.h), judged by its energy difference (EnergyFunction.h), carried out and
 * undone by AdjacencyComplex::Apply(). The removed tetrahedra form a ball, and the created ones fill the same ball:
 * both have the same boundary. `created` tetrahedra are positively oriented. The edges are those that are there only
 * before and only after. */
struct Replacement
{
  template <typename T>
  using List = boost::container::small_vector<T, 12>;

  List<TetrahedronId>   removed;
  List<VertexQuadruple> created;
  List<VertexPair>      removedEdges;
  List<VertexPair>      createdEdges;
};
} // namespace tissue

#endif
