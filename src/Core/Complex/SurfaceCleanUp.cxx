/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Complex/SurfaceCleanUp.h"

#include "Complex/AdjacencyComplex.h"
#include "Complex/LocalOperations.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
class CleanUp
{
public:
  CleanUp(AdjacencyComplex & complex, const std::vector<Point> & centers, const SurfaceCleanUpParameters & parameters)
    : m_Complex(complex)
    , m_Centers(centers)
    , m_Parameters(parameters)
    , m_Operations(complex, centers, Legality::Combinatorial)
  {}

  SurfaceCleanUpResult
  Run()
  {
    std::size_t before = 0;
    do
    {
      before = m_Result.numberOfSwaps + m_Result.numberOfRemovals;
      Pass();
    } while (m_Result.numberOfSwaps + m_Result.numberOfRemovals > before);
    return m_Result;
  }

private:
  bool
  IsOversized(VertexId u, VertexId v) const
  {
    return Distance(m_Centers[u], m_Centers[v]) > MaximumEdgeLength(u, v);
  }

  double
  MaximumEdgeLength(VertexId u, VertexId v) const
  {
    const std::vector<double> & local = m_Parameters.localLengths;
    return m_Parameters.maximumEdgeLength * (local.empty() ? 1.0 : 0.5 * (local[u] + local[v]));
  }

  /** Tries every surface triangle once. */
  void
  Pass()
  {
    for (TetrahedronId id = 0; id < m_Complex.TetrahedronIdBound(); ++id)
    {
      if (m_Complex.IsAlive(id))
      {
        const auto & vertices = m_Complex.GetTetrahedron(id).vertices;
        const auto   at = std::find(vertices.begin(), vertices.end(), ExteriorVertex);
        if (at != vertices.end())
        {
          CleanTriangle(id, static_cast<int>(at - vertices.begin()));
        }
      }
    }
  }

  /** Removes the surface triangle of tetrahedron `id`, opposite to its vertex `i`, the exterior, if it is oversized: by
   * a swap, or, where that is illegal, by the removal of an oversized edge of degree 3. */
  void
  CleanTriangle(TetrahedronId id, int i)
  {
    const VertexTriple t = TriangleOpposite(m_Complex.GetTetrahedron(id).vertices, i);
    const VertexPair   edges[3] = { { { t[0], t[1] } }, { { t[1], t[2] } }, { { t[2], t[0] } } };
    if (std::none_of(std::begin(edges), std::end(edges), [this](VertexPair e) { return IsOversized(e[0], e[1]); }))
    {
      return;
    }
    if (const Proposal swap = m_Operations.SwapTriangle(id, i))
    {
      m_Complex.Apply(swap.replacement);
      ++m_Result.numberOfSwaps;
      return;
    }
    for (const VertexPair & edge : edges)
    {
      if (IsOversized(edge[0], edge[1]) && m_Complex.FindEdge(edge[0], edge[1])->degree == 3)
      {
        // A ring of three has one triangulation, whatever its cost.
        const auto noCost = [](const AdjacencyComplex::Ring &, int, int, int) { return 0.0; };
        if (const Proposal removal = m_Operations.RemoveEdge(edge, noCost))
        {
          m_Complex.Apply(removal.replacement);
          ++m_Result.numberOfRemovals;
          return;
        }
      }
    }
  }

  AdjacencyComplex &               m_Complex;
  const std::vector<Point> &       m_Centers;
  const SurfaceCleanUpParameters & m_Parameters;
  LocalOperations                  m_Operations;
  SurfaceCleanUpResult             m_Result;
};
} // namespace

SurfaceCleanUpResult
CleanSurface(AdjacencyComplex & complex, const std::vector<Point> & centers,
             const SurfaceCleanUpParameters & parameters)
{
  return CleanUp(complex, centers, parameters).Run();
}

} // namespace tissue
