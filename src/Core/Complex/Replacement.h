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
/** Index of a tetrahedron of an AdjacencyComplex, which is given to another one once its tetrahedron is gone. */
using TetrahedronId = std::int32_t;

/** \brief A local change of the adjacency complex, as a value: tetrahedra out, tetrahedra in.
 *
 * A pure function proposes it (LocalOperations.h), its energy difference judges it (EnergyFunction.h), and
 * AdjacencyComplex::Apply() carries it out and undoes it. The removed tetrahedra form a ball, and the created ones fill
 * the same ball: both have the same boundary. The created tetrahedra are positively oriented. `removedEdges` are there
 * only before, `createdEdges` only after. */
struct Replacement
{
  /** A list with room for 12 entries before memory must be allocated: the removal of an edge of degree 8 creates that
   * many tetrahedra. */
  template <typename T>
  using List = boost::container::small_vector<T, 12>;

  List<TetrahedronId>   removed;
  List<VertexQuadruple> created;
  List<VertexPair>      removedEdges;
  List<VertexPair>      createdEdges;
};
} // namespace tissue

#endif
