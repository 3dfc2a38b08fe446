/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/SpatialOrder.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <numeric>

namespace tissue
{
namespace
{
/** Returns what rest(point) leaves of that point of which it leaves the longest vector; {0, 0, 0} where it leaves
 * nothing of any point. */
template <typename TRest>
Point
FindFarthest(const std::vector<Point> & points, const TRest & rest)
{
  Point  farthest{ { 0.0, 0.0, 0.0 } };
  double largest = 0.0;
  for (const Point & point : points)
  {
    const Point  left = rest(point);
    const double squared = Dot(left, left);
    if (squared > largest)
    {
      largest = squared;
      farthest = left;
    }
  }
  return farthest;
}

/** Returns the points in axes that turn and mirror with them. The origin is their mean, the first axis goes through the
 * point farthest from it, the second towards the point farthest from the first, and the third, across both, to that
 * side on which a point is farthest from their plane. */
std::vector<Point>
InOwnFrame(std::vector<Point> points)
{
  Point sum{ { 0.0, 0.0, 0.0 } };
  for (const Point & point : points)
  {
    sum = sum + point;
  }
  const Point mean = (1.0 / static_cast<double>(points.size())) * sum;
  for (Point & point : points)
  {
    point = point - mean;
  }
  const Point u = Normalized(FindFarthest(points, [](const Point & p) { return p; }));
  const Point v = Normalized(FindFarthest(points, [&u](const Point & p) { return p - Dot(p, u) * u; }));
  const Point across = Cross(u, v);
  // The cross product alone would make the axes of a mirror image no mirror image of the axes.
  const Point w = Normalized(FindFarthest(points, [&across](const Point & p) { return Dot(p, across) * across; }));
  for (Point & point : points)
  {
    point = { { Dot(point, u), Dot(point, v), Dot(point, w) } };
  }
  return points;
}
} // namespace

std::vector<std::int32_t>
HilbertOrder(const std::vector<Point> & points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> places;
  places.reserve(points.size());
  for (const Point & p : points)
  {
    places.emplace_back(p[0], p[1], p[2]);
  }
  const auto positions = CGAL::make_property_map(places);
  using Traits = CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(CGAL::make_property_map(places))>;

  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  CGAL::hilbert_sort(order.begin(), order.end(), Traits(positions));
  return { order.begin(), order.end() };
}

std::vector<VertexId>
SpatialOrder(const std::vector<Point> & centers)
{
  if (centers.size() < 2)
  {
    return std::vector<VertexId>(centers.size(), ExteriorVertex);
  }
  std::vector<VertexId> order{ ExteriorVertex };
  order.reserve(centers.size());
  for (const std::int32_t i : HilbertOrder(InOwnFrame({ centers.begin() + 1, centers.end() })))
  {
    order.push_back(i + 1);
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
