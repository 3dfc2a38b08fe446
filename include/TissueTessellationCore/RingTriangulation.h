/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_RingTriangulation_h
#define TissueTessellationCore_RingTriangulation_h

#include "TissueTessellationCore/Types.h"

#include <functional>
#include <vector>

namespace tissue
{
/** Triangles of a polygon's triangulation, by the indices of its corners, each ascending: n - 2 of them. */
using RingTriangulation = std::vector<std::array<int, 3>>;

/** Cost of the triangle of the polygon's corners i < j < k: at least 0, infinite where the triangle is not allowed. */
using TriangleCost = std::function<double(int i, int j, int k)>;

/** \brief The triangulation of a polygon of n >= 3 corners that has the least sum of costs, by dynamic programming.
 *
 * O(n^3) time, O(n^2) memory. Of equal sums the one with the smaller splitting corner wins, so the result is unique.
 * Empty where every triangulation has an infinite cost. */
RingTriangulation
LeastCostTriangulation(int numberOfCorners, const TriangleCost & cost);

/** \brief The cost under which the least-cost triangulation of a plane polygon is its (constrained) Delaunay
 * triangulation.
 *
 * (a^2 + b^2 + c^2) / area of a counterclockwise triangle of edges a, b, c: every flip towards Delaunay lowers the sum
 * (O. R. Musin, Properties of the Delaunay triangulation, Symposium on Computational Geometry 1997,
 * doi:10.1145/262839.263061). Infinite for a triangle that is not counterclockwise. */
double
DelaunayCost(const std::array<double, 2> & a, const std::array<double, 2> & b, const std::array<double, 2> & c);
} // namespace tissue

#endif
