/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/PatchSurface.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
/** The unit square in the plane z = 0, in n x n squares of two triangles, its vertices in no order of the outline. */
WallPatch
Square(int n)
{
  std::vector<Point>                            points;
  std::vector<std::array<WallPatch::Vertex, 3>> triangles;
  for (int y = 0; y <= n; ++y)
  {
    for (int x = 0; x <= n; ++x)
    {
      points.push_back({ { static_cast<double>(x) / n, static_cast<double>(y) / n, 0.0 } });
      if (x < n && y < n)
      {
        const int a = y * (n + 1) + x;
        triangles.push_back({ { a, a + 1, a + n + 2 } });
        triangles.push_back({ { a, a + n + 2, a + n + 1 } });
      }
    }
  }
  return WallPatch(points, triangles, static_cast<WallPatch::Vertex>(points.size()));
}
} // namespace

TEST(PatchSurface, FootOfAPointAboveASquareIsBelowIt)
{
  const PatchSurface surface(Square(8));
  Random             random(1);
  for (int i = 0; i < 200; ++i)
  {
    const double x = random.Uniform();
    const double y = random.Uniform();
    const auto   start = static_cast<std::int32_t>(random.Uniform() * 128);
    const auto   foot = surface.FindFoot({ { x, y, 0.3 } }, start);
    EXPECT_NEAR(Distance(foot.point, { { x, y, 0.0 } }), 0.0, 1e-9);
    EXPECT_NEAR(foot.normal[2], 1.0, 1e-12);
  }
}

TEST(PatchSurface, FootOfAPointBesideASquareIsOnItsOutline)
{
  const PatchSurface surface(Square(4));
  EXPECT_NEAR(Distance(surface.FindFoot({ { 2.0, 0.3, 0.1 } }, 0).point, { { 1.0, 0.3, 0.0 } }), 0.0, 1e-9);
  EXPECT_NEAR(Distance(surface.FindFoot({ { -1.0, -1.0, 0.1 } }, 31).point, { { 0.0, 0.0, 0.0 } }), 0.0, 1e-9);
}

TEST(PatchSurface, AVertexIsItsOwnFoot)
{
  const WallPatch    patch = Square(2);
  const PatchSurface surface(patch);
  for (WallPatch::Vertex v = 0; v < patch.EndOfVertices(); ++v)
  {
    const auto foot = surface.FootAt(v);
    EXPECT_EQ(foot.point, patch.PointAt(v));
    EXPECT_NEAR(Distance(surface.FindFoot(foot.point, foot.triangle).point, foot.point), 0.0, 1e-12);
  }
}
