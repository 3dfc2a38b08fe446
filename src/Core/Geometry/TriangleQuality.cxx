/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Geometry/TriangleQuality.h"

#include <algorithm>
#include <numeric>

namespace tissue
{
namespace
{
double
SumOfSquares(const Point & a, const Point & b, const Point & c)
{
  const Point ab = b - a;
  const Point bc = c - b;
  const Point ca = a - c;
  return Dot(ab, ab) + Dot(bc, bc) + Dot(ca, ca);
}
} // namespace

double
TriangleQuality(const Point & a, const Point & b, const Point & c)
{
  const double squares = SumOfSquares(a, b, c);
  return squares > 0.0 ? 2.0 * std::sqrt(3.0) * Norm(Cross(b - a, c - a)) / squares : 0.0;
}

Point
TriangleDistortionGradient(const Point & a, const Point & b, const Point & c)
{
  // With s the sum of squares and n the normal, the distortion is s^2 / (12 n^2), and its gradient is
  // s / (6 n^2) grad s - s^2 / (12 n^4) grad n^2.
  const double squares = SumOfSquares(a, b, c);
  const Point  normal = Cross(b - a, c - a);
  const double area = Dot(normal, normal);
  const Point  ofSquares = 2.0 * ((a - b) + (a - c));
  const Point  ofArea = 2.0 * Cross(normal, c - b);
  return (squares / (6.0 * area)) * ofSquares - (squares * squares / (12.0 * area * area)) * ofArea;
}

QualitySummary
SummarizeTriangleQuality(const std::vector<Point> & points, const std::vector<Triangle> & triangles)
{
  QualitySummary      summary;
  std::vector<double> qualities;
  qualities.reserve(triangles.size());
  for (const auto & t : triangles)
  {
    qualities.push_back(TriangleQuality(points[t[0]], points[t[1]], points[t[2]]));
  }
  if (!qualities.empty())
  {
    std::sort(qualities.begin(), qualities.end());
    summary.mean = std::accumulate(qualities.begin(), qualities.end(), 0.0) / static_cast<double>(qualities.size());
    summary.fifthPercentile = qualities[qualities.size() / 20];
    summary.least = qualities.front();
  }
  return summary;
}
} // namespace tissue
