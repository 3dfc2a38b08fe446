/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LinkSurface_h
#define TissueTessellationCore_LinkSurface_h

#include "Nerve/GeneralComplex.h"

#include <cstdint>
#include <unordered_map>

namespace tissue
{
/** \brief One component of the link of a vertex, as the surface it is: its vertices are edges of the complex.
 *
 * A snapshot: of no use once the complex has changed. Linear in the component's size. */
class LinkSurface
{
public:
  /** The component that a tetrahedron's triangle opposite to a local vertex is in: that of the vertex. */
  LinkSurface(const GeneralComplex & complex, const Side & triangle);

  /** The edges, each once, from the vertex to its neighbour. */
  const std::vector<LocalEdge> &
  GetEdges() const
  {
    return m_Edges;
  }

  /** The triangles of the component, as sides opposite to the vertex. */
  const std::vector<Side> &
  GetTriangles() const
  {
    return m_Triangles;
  }

  /** The index of the edge from the vertex to the local vertex `to` of a tetrahedron; -1 if it is not of this
   * component.
   */
  std::int32_t
  FindEdge(TetrahedronId tetrahedron, int to) const
  {
    const auto at = m_EdgeOf.find(4 * static_cast<std::int64_t>(tetrahedron) + to);
    return at == m_EdgeOf.end() ? -1 : at->second;
  }

  bool
  Contains(TetrahedronId tetrahedron, int to) const
  {
    return this->FindEdge(tetrahedron, to) >= 0;
  }

private:
  std::vector<LocalEdge>                         m_Edges;
  std::vector<Side>                              m_Triangles;
  std::unordered_map<std::int64_t, std::int32_t> m_EdgeOf;
};
} // namespace tissue

#endif
