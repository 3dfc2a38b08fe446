/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/SurfaceLift.h"

#include "Common/Algorithms.h"
#include "Complex/RelativeExterior.h"
#include "Complex/SurfaceHeights.h"
#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue
{
namespace
{
/** Returns the depths of the vertices at the exterior, and 0 for all others. For each vertex the lengths of its edges
 * are collected, and the heights of its centre above the neighbours below it; half the median of the heights, or of the
 * lengths where no neighbour is below, is its depth. */
std::vector<double>
EstimateDepths(const AdjacencyComplex & complex, const std::vector<Point> & centers, const std::vector<Point> & normals)
{
  const std::vector<std::vector<double>> heights = CollectHeights(complex, centers, normals);
  std::vector<std::vector<double>>       distances(centers.size());
  for (const AdjacencyComplex::Edge & edge : complex.GetEdges())
  {
    const auto [u, v] = edge.vertices;
    if (u != ExteriorVertex)
    {
      distances[u].push_back(Distance(centers[u], centers[v]));
      distances[v].push_back(Distance(centers[u], centers[v]));
    }
  }
  std::vector<double> depths(centers.size(), 0.0);
  for (std::size_t v = ExteriorVertex + 1; v < centers.size(); ++v)
  {
    const std::vector<double> & lengths = heights[v].empty() ? distances[v] : heights[v];
    if (Norm(normals[v]) > 0.0 && !lengths.empty())
    {
      depths[v] = 0.5 * Median(lengths);
    }
  }
  return depths;
}
} // namespace

void
LiftSurfaceCorners(const AdjacencyComplex & complex, const std::vector<Point> & centers, std::vector<Point> & corners)
{
  const std::vector<Point>           normals = RelativeExterior(complex, centers).Normals();
  const std::vector<double>          depths = EstimateDepths(complex, centers, normals);
  const std::vector<VertexQuadruple> tetrahedra = complex.GetTetrahedra();
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
  {
    const VertexQuadruple & t = tetrahedra[i];
    if (t[0] == ExteriorVertex)
    {
      const double depth = (depths[t[1]] + depths[t[2]] + depths[t[3]]) / 3.0;
      corners[i] = corners[i] + depth * Normalized(normals[t[1]] + normals[t[2]] + normals[t[3]]);
    }
  }
}
} // namespace tissue
