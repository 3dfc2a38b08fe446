/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/SpatialOrder.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <numeric>

namespace tissue
{
std::vector<VertexId>
SpatialOrder(const std::vector<Point> & centers)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  points.reserve(centers.size());
  for (const Point & center : centers)
  {
    points.emplace_back(center[0], center[1], center[2]);
  }
  const auto positions = CGAL::make_property_map(points);
  using Traits = CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(CGAL::make_property_map(points))>;

  std::vector<std::size_t> indices(centers.size());
  std::iota(indices.begin(), indices.end(), std::size_t{ 0 });
  if (indices.size() > 1)
  {
    CGAL::hilbert_sort(indices.begin() + 1, indices.end(), Traits(positions));
  }
  std::vector<VertexId> order;
  order.reserve(indices.size());
  for (const std::size_t i : indices)
  {
    order.push_back(static_cast<VertexId>(i));
  }
  return order;
}

std::vector<VertexId>
RanksInOrder(const std::vector<VertexId> & order)
{
  std::vector<VertexId> ranks(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    ranks[order[i]] = static_cast<VertexId>(i);
  }
  return ranks;
}
} // namespace tissue
