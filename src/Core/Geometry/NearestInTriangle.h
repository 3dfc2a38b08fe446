/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_NearestInTriangle_h
#define TissueTessellationCore_NearestInTriangle_h

#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue
{
/** Barycentric weights of the three corners. */
using TriangleWeights = std::array<double, 3>;

/** Returns the weights of the point of a triangle that is nearest to p (C. Ericson, Real-Time Collision Detection,
 * 5.1.5). The regions of space whose nearest point is a corner, or on an edge, are ruled out one after the other; what
 * is left is above the inside. The products d1 to d6 tell how far p is along the edges from each corner; va, vb and vc
 * are the barycentric weights of p, projected to the triangle's plane, times the squared normal. */
TriangleWeights
NearestInTriangle(const Point & p, const Point & a, const Point & b, const Point & c);

/** The point of those weights. */
inline Point
Combine(const TriangleWeights & weights, const Point & a, const Point & b, const Point & c)
{
  return weights[0] * a + weights[1] * b + weights[2] * c;
}
} // namespace tissue

#endif
