/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/SurfaceHeights.h"

#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue
{
std::vector<std::vector<double>>
CollectHeights(const AdjacencyComplex & complex, const std::vector<Point> & centers, const std::vector<Point> & normals)
{
  // A neighbour is below where the line to it is so steep, as a cosine.
  constexpr double steepest = 0.3;

  std::vector<std::vector<double>> heights(centers.size());
  const auto                       add = [&](VertexId above, VertexId below) {
    const Point  offset = centers[above] - centers[below];
    const double height = Dot(offset, normals[above]);
    if (height > steepest * Norm(offset))
    {
      heights[above].push_back(height);
    }
  };
  for (const AdjacencyComplex::Edge & edge : complex.GetEdges())
  {
    if (edge.vertices[0] != ExteriorVertex)
    {
      add(edge.vertices[0], edge.vertices[1]);
      add(edge.vertices[1], edge.vertices[0]);
    }
  }
  return heights;
}
} // namespace tissue
