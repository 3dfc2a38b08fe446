/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_RingTriangulation_h
#define TissueTessellationCore_RingTriangulation_h

#include "TissueTessellationCore/Common/Types.h"

#include <boost/container/small_vector.hpp>

#include <limits>

namespace tissue
{
/** The n - 2 triangles of a triangulation of a polygon of n corners, each by the indices of its corners, ascending.
 * There is room for a polygon of 12 before memory must be allocated, here and in the tables below; more are rare. */
using RingTriangulation = boost::container::small_vector<std::array<int, 3>, 10>;

/** \brief Returns the triangulation of a polygon of n >= 3 corners that has the least sum of costs.
 *
 * It is found by dynamic programming, in a time of O(n^3) and a memory of O(n^2). Of equal sums the one with the
 * smaller splitting corner wins, so that the result is unique. It is empty where every triangulation has an infinite
 * cost.
 *
 * `cost(i, j, k)` is the cost of the triangle of the polygon's corners i < j < k: at least 0, and infinite where the
 * triangle is not allowed. This is a template because the optimization spends most of its time here. */
template <typename TCost>
RingTriangulation
LeastCostTriangulation(int n, const TCost & cost)
{
  // The polygon of the corners i ... k has one triangle (i, j, k) on its side (i, k), which leaves the polygons i ... j
  // and j ... k: least(i, k) = min over j of least(i, j) + least(j, k) + cost(i, j, k). Short polygons come before long
  // ones, and no cost is asked for where the parts alone are too much. The best j then lead from the whole down.
  constexpr double                            infinite = std::numeric_limits<double>::infinity();
  const auto                                  at = [n](int i, int k) { return static_cast<std::size_t>(i * n + k); };
  boost::container::small_vector<double, 144> least(at(n, 0), 0.0);
  boost::container::small_vector<int, 144> split(at(n, 0), -1); // The third corner of its triangle on the side (i, k).
  for (int length = 2; length < n; ++length)
  {
    for (int i = 0; i + length < n; ++i)
    {
      const int k = i + length;
      least[at(i, k)] = infinite;
      for (int j = i + 1; j < k; ++j)
      {
        const double parts = least[at(i, j)] + least[at(j, k)];
        if (parts >= least[at(i, k)])
        {
          continue;
        }
        const double sum = parts + cost(i, j, k);
        if (sum < least[at(i, k)])
        {
          least[at(i, k)] = sum;
          split[at(i, k)] = j;
        }
      }
    }
  }
  RingTriangulation triangles;
  if (n < 3 || least[at(0, n - 1)] == infinite)
  {
    return triangles;
  }
  boost::container::small_vector<std::array<int, 2>, 24> open{ { { 0, n - 1 } } };
  while (!open.empty())
  {
    const int i = open.back()[0];
    const int k = open.back()[1];
    open.pop_back();
    if (k - i >= 2)
    {
      const int j = split[at(i, k)];
      triangles.push_back({ { i, j, k } });
      open.push_back({ { i, j } });
      open.push_back({ { j, k } });
    }
  }
  return triangles;
}

/** \brief Returns the cost under which the least-cost triangulation of a plane polygon is its (constrained) Delaunay
 * triangulation.
 *
 * It is (a^2 + b^2 + c^2) / area for a counterclockwise triangle of edges a, b, c, and infinite for any other. Every
 * flip towards Delaunay lowers the sum (O. R. Musin, Properties of the Delaunay triangulation, Symposium on
 * Computational Geometry 1997, doi:10.1145/262839.263061). */
double
DelaunayCost(const std::array<double, 2> & a, const std::array<double, 2> & b, const std::array<double, 2> & c);
} // namespace tissue

#endif
