/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_RelativeExterior_h
#define TissueTessellationCore_RelativeExterior_h

#include "Complex/AdjacencyComplex.h"

#include <vector>

namespace tissue
{
/** \brief Where the exterior lies, seen from an element of the complex (paper, section 3.3).
 *
 * The exterior vertex has no position of its own. Relative to an element it is placed at a typical distance from the
 * element's barycentre along the mean of the outward normals of its vertices. A vertex's normal is the area-weighted
 * sum of those of the surface triangles around it, taken from the complex as it is at the time of the call. */
class RelativeExterior
{
public:
  /** Both references must outlive this object. `centers` has a position for every vertex, ignored for the exterior. */
  RelativeExterior(const AdjacencyComplex & complex, const std::vector<Point> & centers)
    : m_Complex(complex)
    , m_Centers(centers)
  {}

  /** Returns the outward unit normal of the surface at a vertex; zero where the vertex does not touch the exterior. */
  Point
  Normal(VertexId vertex) const;

  /** Gives the normals of all vertices. */
  std::vector<Point>
  Normals() const;

  /** Places the exterior for the edge from it to `vertex`: as far from the vertex as the edge's ring is in the mean. */
  Point
  OfExteriorEdge(VertexId vertex) const;

  /** Places the exterior for an edge whose ring holds it: at the edge's length from its middle. */
  Point
  OfEdge(VertexId u, VertexId v) const;

  /** Places the exterior for a triangle that has it on one side: at its mean edge length from its barycentre. */
  Point
  OfTriangle(const VertexTriple & triangle) const;

private:
  const AdjacencyComplex &   m_Complex;
  const std::vector<Point> & m_Centers;
};
} // namespace tissue

#endif
