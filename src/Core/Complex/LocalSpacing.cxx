/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/LocalSpacing.h"

#include "Common/Algorithms.h"
#include "Geometry/NearestPoints.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace tissue
{
namespace
{
/** The number of nearest points over whose distances the local spacing is the mean. Fewer would follow single close
 * pairs, more would reach beyond the neighbours of a cell (9 in the epidermis and 13 inside in the mean; paper, section
 * 3.4). */
constexpr std::size_t NumberOfNearest = 8;

std::vector<std::vector<VertexId>>
CollectNeighbors(const AdjacencyComplex & complex)
{
  std::vector<std::vector<VertexId>> neighbors(static_cast<std::size_t>(complex.NumberOfVertices()));
  for (const AdjacencyComplex::Edge & edge : complex.GetEdges())
  {
    if (edge.vertices[0] != ExteriorVertex)
    {
      neighbors[edge.vertices[0]].push_back(edge.vertices[1]);
      neighbors[edge.vertices[1]].push_back(edge.vertices[0]);
    }
  }
  return neighbors;
}

/** In a Delaunay tetrahedralization the next nearest vertex is a neighbour of this one or of one that is nearer. So a
 * walk along edges, always to the nearest vertex seen, meets the nearest ones in their order. */
double
MeanDistanceOfNearest(VertexId vertex, const std::vector<std::vector<VertexId>> & neighbors,
                      const std::vector<Point> & centers)
{
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  std::vector<VertexId>                                          seen{ vertex };
  const auto                                                     see = [&](VertexId from) {
    for (const VertexId v : neighbors[from])
    {
      if (std::find(seen.begin(), seen.end(), v) == seen.end())
      {
        seen.push_back(v);
        next.emplace(Distance(centers[vertex], centers[v]), v);
      }
    }
  };
  see(vertex);
  double      sum = 0.0;
  std::size_t count = 0;
  for (; count < NumberOfNearest && !next.empty(); ++count)
  {
    const Entry nearest = next.top();
    next.pop();
    sum += nearest.first;
    see(nearest.second);
  }
  return sum / static_cast<double>(std::max<std::size_t>(count, 1));
}
} // namespace

std::vector<double>
LocalSpacings(const AdjacencyComplex & complex, const std::vector<Point> & centers)
{
  const auto          neighbors = CollectNeighbors(complex);
  std::vector<double> spacings(centers.size(), 0.0);
  for (VertexId v = ExteriorVertex + 1; v < complex.NumberOfVertices(); ++v)
  {
    spacings[v] = MeanDistanceOfNearest(v, neighbors, centers);
  }
  return spacings;
}

std::vector<double>
LocalSpacings(const std::vector<Point> & points)
{
  std::vector<double> spacings{ 0.0 };
  const auto          nearest = FindNearestPoints(points, NumberOfNearest);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    double sum = 0.0;
    for (const std::size_t other : nearest[i])
    {
      sum += Distance(points[i], points[other]);
    }
    spacings.push_back(sum / static_cast<double>(std::max<std::size_t>(nearest[i].size(), 1)));
  }
  return spacings;
}

double
MedianSpacing(const std::vector<double> & spacings)
{
  return Median({ spacings.begin() + ExteriorVertex + 1, spacings.end() });
}
} // namespace tissue
