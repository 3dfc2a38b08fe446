/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/LinkSurface.h"

namespace tissue
{
LinkSurface::LinkSurface(const GeneralComplex & complex, const Side & triangle)
{
  const VertexId vertex = complex.VertexOpposite(triangle);
  const auto     key = [](TetrahedronId t, int i) { return 4 * static_cast<std::int64_t>(t) + i; };
  // Every triangle is reached along the edges of those before it: the ring of an edge holds all triangles around it.
  m_Triangles.push_back(triangle);
  for (std::size_t k = 0; k < m_Triangles.size(); ++k)
  {
    const Side side = m_Triangles[k];
    for (int to = 0; to < 4; ++to)
    {
      if (to == side.opposite || m_EdgeOf.count(key(side.tetrahedron, to)) != 0)
      {
        continue;
      }
      const auto index = static_cast<std::int32_t>(m_Edges.size());
      m_Edges.push_back({ side.tetrahedron, side.opposite, to });
      for (const RingStep & step : complex.GetRing(m_Edges.back()))
      {
        bool isKnown = step.tetrahedron == triangle.tetrahedron;
        for (int i = 0; i < 4; ++i)
        {
          isKnown = isKnown || m_EdgeOf.count(key(step.tetrahedron, i)) != 0;
        }
        m_EdgeOf.emplace(key(step.tetrahedron, step.to), index);
        if (!isKnown)
        {
          m_Triangles.push_back(
            { step.tetrahedron, LocalIndex(complex.GetTetrahedron(step.tetrahedron).vertices, vertex) });
        }
      }
    }
  }
}
} // namespace tissue
