/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Vector_h
#define TissueTessellationCore_Vector_h

#include "TissueTessellationCore/Common/Types.h"

#include <cmath>

namespace tissue
{
/** The arithmetic of points and vectors. */
inline Point
operator+(const Point & a, const Point & b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}

inline Point
operator-(const Point & a, const Point & b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

inline Point
operator*(double factor, const Point & a)
{
  return { { factor * a[0], factor * a[1], factor * a[2] } };
}

inline double
Dot(const Point & a, const Point & b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point
Cross(const Point & a, const Point & b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

inline double
Norm(const Point & a)
{
  return std::sqrt(Dot(a, a));
}

inline double
Distance(const Point & a, const Point & b)
{
  return Norm(b - a);
}

inline double
TriangleArea(const Point & a, const Point & b, const Point & c)
{
  return 0.5 * Norm(Cross(b - a, c - a));
}

/** Returns the vector scaled to the length 1; the zero vector stays zero. */
inline Point
Normalized(const Point & a)
{
  const double length = Norm(a);
  return length > 0.0 ? (1.0 / length) * a : a;
}
} // namespace tissue

#endif
