/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_VertexLinks_h
#define TissueTessellationCore_VertexLinks_h

#include "Nerve/GeneralComplex.h"

#include <vector>

namespace tissue
{
/** A connected component of the link of a vertex: a closed surface, which is the boundary of a piece of the cell. */
struct VertexLink
{
  VertexId     vertex;
  std::int32_t numberOfTriangles;
  /** V - E + F: 2 of a sphere, 0 of a torus, -2 of two handles. */
  std::int32_t eulerCharacteristic;
  /** The tetrahedron of the smallest id that the component has a triangle of. */
  TetrahedronId first;
};

/** The links of all vertices, taken apart into their components. */
struct VertexLinks
{
  /** Ascending by their vertices, then by their first tetrahedra. */
  std::vector<VertexLink> links;
  /** Of each tetrahedron id, and of each of its local vertices, the index of the component that the opposite triangle
   * belongs to; -1 where the id is not taken. */
  std::vector<std::array<std::int32_t, 4>> linkOf;
  /** Of each vertex, the index of its first component; one more at the end. */
  std::vector<std::size_t> firstOfVertex;

  std::size_t
  NumberOfLinks(VertexId v) const
  {
    return firstOfVertex[v + 1] - firstOfVertex[v];
  }
};

/** Of a complex all of whose triangles are glued. Linear in the number of tetrahedra. */
VertexLinks
FindVertexLinks(const GeneralComplex & complex);
} // namespace tissue

#endif
