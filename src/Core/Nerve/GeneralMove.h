/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_GeneralMove_h
#define TissueTessellationCore_GeneralMove_h

#include "Nerve/GeneralComplex.h"

namespace tissue
{
/** \brief A local change of a general complex, as a value: tetrahedra out, tetrahedra in, and how to glue them.
 *
 * Proposed by a pure function (GeneralMoves.h), judged by its difference of energy (PlaceEnergy.h), carried out and
 * undone by GeneralComplex::Apply(). Gluings are by ring index, never by the vertices of triangles: of several
 * triangles with the same vertices nothing else tells which is which. A side names a tetrahedron that stays by its id,
 * the k-th created one by Created(k). The edges are the differences of the numbers of edges, by their vertices,
 * ascending. */
struct GeneralMove
{
  template <typename T>
  using List = boost::container::small_vector<T, 12>;

  struct NewTetrahedron
  {
    VertexQuadruple vertices;
    CornerId        corner = NoPlace;
  };

  struct Gluing
  {
    Side   a;
    Side   b;
    LineId line = NoPlace;
  };

  List<TetrahedronId>  removed;
  List<NewTetrahedron> created;
  List<Gluing>         gluings;
  List<VertexPair>     removedEdges;
  List<VertexPair>     createdEdges;

  /** How a side names the k-th created tetrahedron; below every id. */
  static TetrahedronId
  Created(std::size_t k)
  {
    return -2 - static_cast<TetrahedronId>(k);
  }

  static bool
  IsCreated(TetrahedronId name)
  {
    return name <= -2;
  }

  /** The index among `created` of a tetrahedron so named. */
  static std::size_t
  IndexOfCreated(TetrahedronId name)
  {
    return static_cast<std::size_t>(-2 - name);
  }
};
} // namespace tissue

#endif
