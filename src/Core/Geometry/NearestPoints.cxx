/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/NearestPoints.h"

#include "TissueTessellationCore/Geometry/Box.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tissue
{
namespace
{
/** A k-d tree without nodes: the points in an order in which the middle one of each range splits it in two along the
 * longest side of its box, down to ranges of a few. */
class PointTree
{
public:
  explicit PointTree(const std::vector<Point> & points)
    : m_Points(points)
    , m_Order(points.size())
    , m_Axes(points.size(), 0)
  {
    std::iota(m_Order.begin(), m_Order.end(), std::size_t{ 0 });
    this->Split(0, points.size());
  }

  std::vector<std::size_t>
  FindNearest(std::size_t to, std::size_t count) const
  {
    Search search{ to, count, {} };
    this->Visit(search, 0, m_Order.size());
    std::sort_heap(search.found.begin(), search.found.end());
    std::vector<std::size_t> nearest;
    for (const auto & [distance, point] : search.found)
    {
      nearest.push_back(point);
    }
    return nearest;
  }

private:
  static constexpr std::size_t LeafSize = 8;

  /** The nearest so far by squared distance and index, as a heap with the farthest on top. */
  struct Search
  {
    std::size_t                                 to;
    std::size_t                                 count;
    std::vector<std::pair<double, std::size_t>> found;
  };

  void
  Split(std::size_t begin, std::size_t end)
  {
    if (end - begin <= LeafSize)
    {
      return;
    }
    Box box{ m_Points[m_Order[begin]], m_Points[m_Order[begin]] };
    for (std::size_t i = begin; i < end; ++i)
    {
      Extend(box, m_Points[m_Order[i]]);
    }
    const Point       extent = box.upper - box.lower;
    const auto        axis = std::max_element(extent.begin(), extent.end()) - extent.begin();
    const std::size_t middle = (begin + end) / 2;
    const auto        at = [this](std::size_t i) { return m_Order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t i, std::size_t j) {
      return std::pair(m_Points[i][axis], i) < std::pair(m_Points[j][axis], j);
    });
    m_Axes[middle] = static_cast<int>(axis);
    this->Split(begin, middle);
    this->Split(middle + 1, end);
  }

  void
  Visit(Search & search, std::size_t begin, std::size_t end) const
  {
    if (end - begin <= LeafSize)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Offer(search, m_Order[i]);
      }
      return;
    }
    const std::size_t middle = (begin + end) / 2;
    const int         axis = m_Axes[middle];
    const double      beyond = m_Points[search.to][axis] - m_Points[m_Order[middle]][axis];
    this->Offer(search, m_Order[middle]);
    const std::pair<std::size_t, std::size_t> below{ begin, middle };
    const std::pair<std::size_t, std::size_t> above{ middle + 1, end };
    const auto & [nearer, farther] = beyond < 0.0 ? std::pair(below, above) : std::pair(above, below);
    this->Visit(search, nearer.first, nearer.second);
    if (search.found.size() < search.count || beyond * beyond <= search.found.front().first)
    {
      this->Visit(search, farther.first, farther.second);
    }
  }

  void
  Offer(Search & search, std::size_t point) const
  {
    if (point == search.to)
    {
      return;
    }
    const Point     offset = m_Points[point] - m_Points[search.to];
    const std::pair entry(Dot(offset, offset), point);
    if (search.found.size() == search.count)
    {
      if (search.count == 0 || !(entry < search.found.front()))
      {
        return;
      }
      std::pop_heap(search.found.begin(), search.found.end());
      search.found.pop_back();
    }
    search.found.push_back(entry);
    std::push_heap(search.found.begin(), search.found.end());
  }

  const std::vector<Point> & m_Points;
  std::vector<std::size_t>   m_Order;
  std::vector<int>           m_Axes;
};
} // namespace

std::vector<std::vector<std::size_t>>
FindNearestPoints(const std::vector<Point> & points, std::size_t count, const Execution & execution)
{
  const PointTree                       tree(points);
  std::vector<std::vector<std::size_t>> nearest(points.size());
  execution.For(points.size(), [&](std::size_t i) { nearest[i] = tree.FindNearest(i, count); });
  return nearest;
}
} // namespace tissue
