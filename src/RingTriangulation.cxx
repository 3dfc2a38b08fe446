/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/RingTriangulation.h"

#include <limits>

namespace tissue
{
RingTriangulation
LeastCostTriangulation(int n, const TriangleCost & cost)
{
  constexpr double    infinite = std::numeric_limits<double>::infinity();
  const auto          at = [n](int i, int k) { return static_cast<std::size_t>(i * n + k); };
  std::vector<double> least(at(n, 0), 0.0); // of the polygon i, i + 1, ..., k
  std::vector<int>    split(at(n, 0), -1);  // the third corner of its triangle on the edge (i, k)
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
  std::vector<std::array<int, 2>> open{ { { 0, n - 1 } } };
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

double
DelaunayCost(const std::array<double, 2> & a, const std::array<double, 2> & b, const std::array<double, 2> & c)
{
  const auto squaredLength = [](const std::array<double, 2> & p, const std::array<double, 2> & q) {
    return (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]);
  };
  const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  return area > 0.0 ? (squaredLength(a, b) + squaredLength(b, c) + squaredLength(c, a)) / area
                    : std::numeric_limits<double>::infinity();
}
} // namespace tissue
