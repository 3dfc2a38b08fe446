/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Mesh/PatchMeasures.h"

#include "TissueTessellationCore/Geometry/TriangleQuality.h"

namespace tissue
{
namespace
{
/** Calls the function with the corners of each triangle. */
template <typename TFunction>
void
ForEachTriangle(const WallPatch & patch, TFunction function)
{
  for (WallPatch::HalfEdge h = 0; h < patch.EndOfHalfEdges(); h += 3)
  {
    if (patch.IsAlive(h))
    {
      function(patch.PointAt(patch.From(h)), patch.PointAt(patch.To(h)), patch.PointAt(patch.Opposite(h)));
    }
  }
}
} // namespace

double
AreaOf(const WallPatch & patch)
{
  double area = 0.0;
  ForEachTriangle(patch, [&](const Point & a, const Point & b, const Point & c) { area += TriangleArea(a, b, c); });
  return area;
}

double
MeanQuality(const WallPatch & patch)
{
  double sum = 0.0;
  int    count = 0;
  ForEachTriangle(patch, [&](const Point & a, const Point & b, const Point & c) {
    sum += TriangleQuality(a, b, c);
    ++count;
  });
  return count > 0 ? sum / count : 0.0;
}
} // namespace tissue
