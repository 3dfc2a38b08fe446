/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TriangleQuality_h
#define TissueTessellationCore_TriangleQuality_h

#include "TissueTessellationCore/Geometry/Vector.h"

#include <limits>
#include <vector>

namespace tissue
{
/** \brief Returns 4 sqrt(3) area / sum of squared edge lengths: 1 for an equilateral triangle, 0 for collinear or equal
 * points (R. E. Bank and R. K. Smith, Mesh smoothing using a posteriori error estimates, SIAM J. Numer. Anal. 34,
 * 1997).
 */
double
TriangleQuality(const Point & a, const Point & b, const Point & c);

/** Returns 1 / TriangleQuality()^2: at least 1, and infinite for a degenerate triangle. It needs no root, so that it is
 * fast enough for inner loops. */
inline double
TriangleDistortion(const Point & a, const Point & b, const Point & c)
{
  const Point  ab = b - a;
  const Point  ac = c - a;
  const Point  bc = c - b;
  const Point  normal = Cross(ab, ac);
  const double squares = Dot(ab, ab) + Dot(ac, ac) + Dot(bc, bc);
  const double area = Dot(normal, normal);
  return area > 0.0 ? squares * squares / (12.0 * area) : std::numeric_limits<double>::infinity();
}

/** Returns the gradient of TriangleDistortion() by its first point, which lies in the triangle's plane. It is not
 * finite for a degenerate triangle. */
Point
TriangleDistortionGradient(const Point & a, const Point & b, const Point & c);

/** \brief The quality of a mesh's triangles. */
struct QualitySummary
{
  double mean = 0.0;
  /** The quality than which a twentieth of the triangles are worse. */
  double fifthPercentile = 0.0;
  double least = 0.0;
};

/** Summarizes the quality of some triangles; without triangles all of the summary is 0. */
QualitySummary
SummarizeTriangleQuality(const std::vector<Point> & points, const std::vector<Triangle> & triangles);
} // namespace tissue

#endif
