/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/PatchRemesher.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace tissue;

namespace
{
using Vertex = WallPatch::Vertex;

/** A polygon in the plane z = 0 around a middle. */
WallPatch
StarOf(std::vector<Point> outline, const Point & middle)
{
  const auto                         n = static_cast<Vertex>(outline.size());
  std::vector<std::array<Vertex, 3>> triangles;
  for (Vertex i = 0; i < n; ++i)
  {
    triangles.push_back({ { n, i, (i + 1) % n } });
  }
  outline.push_back(middle);
  return WallPatch(outline, triangles, n);
}

std::vector<Point>
Rectangle(int width, int height)
{
  std::vector<Point> points;
  for (int i = 0; i < width; ++i)
  {
    points.push_back({ { static_cast<double>(i), 0.0, 0.0 } });
  }
  for (int i = 0; i < height; ++i)
  {
    points.push_back({ { static_cast<double>(width), static_cast<double>(i), 0.0 } });
  }
  const auto half = points.size();
  for (std::size_t i = 0; i < half; ++i)
  {
    points.push_back({ { width - points[i][0], height - points[i][1], 0.0 } });
  }
  return points;
}

void
ExpectUpright(const WallPatch & patch, double area)
{
  double sum = 0.0;
  for (const auto & t : patch.Triangles())
  {
    const Point cross = Cross(patch.PointAt(t[1]) - patch.PointAt(t[0]), patch.PointAt(t[2]) - patch.PointAt(t[0]));
    EXPECT_GT(cross[2], 0.0);
    sum += 0.5 * cross[2];
  }
  EXPECT_NEAR(sum, area, 1e-9);
}

WallPatch
Remeshed(const WallPatch & patch, int numberOfInteriorVertices, const PatchRemesher::ChordRule & mayJoin)
{
  PatchRemesher remesher(patch, mayJoin);
  remesher.Remesh(numberOfInteriorVertices);
  return remesher.TakePatch();
}
} // namespace

TEST(PatchRemesher, HasTheWantedPointsOrOneMoreOrLess)
{
  const WallPatch star = StarOf(Rectangle(8, 6), { { 4.0, 3.0, 0.0 } });
  for (const int wanted : { 2, 10, 16, 17, 60 })
  {
    const WallPatch patch = Remeshed(star, wanted, [](Vertex, Vertex) { return true; });
    EXPECT_NEAR(patch.NumberOfInteriorVertices(), wanted, wanted > 16 ? 0 : 1);
    ExpectUpright(patch, 48.0);
    for (Vertex v = 0; v < star.OutlineSize(); ++v)
    {
      EXPECT_EQ(patch.PointAt(v), star.PointAt(v));
    }
  }
}

TEST(PatchRemesher, JoinsNoTwoVerticesThatMayNotBe)
{
  const WallPatch star = StarOf(Rectangle(12, 1), { { 6.0, 0.5, 0.0 } });
  const auto      outlineChords = [](const WallPatch & patch) {
    int count = 0;
    for (WallPatch::HalfEdge h = 0; h < patch.EndOfHalfEdges(); ++h)
    {
      const bool onOutline = patch.From(h) < patch.OutlineSize() && patch.To(h) < patch.OutlineSize();
      count += onOutline && patch.Twin(h) != WallPatch::None ? 1 : 0;
    }
    return count;
  };
  const WallPatch joined = Remeshed(star, 0, [](Vertex, Vertex) { return true; });
  EXPECT_GT(outlineChords(joined), 0);
  ExpectUpright(joined, 12.0);
  const WallPatch apart = Remeshed(star, 0, [](Vertex, Vertex) { return false; });
  EXPECT_EQ(outlineChords(apart), 0);
  ExpectUpright(apart, 12.0);
}

TEST(PatchRemesher, AnOutlineWithANotchIsNotOverrun)
{
  // Seen from the middle the star has no triangle turned over, though the outline is not convex.
  std::vector<Point> outline = Rectangle(6, 6);
  outline[3] = { { 3.0, 2.0, 0.0 } };
  const WallPatch star = StarOf(outline, { { 3.0, 3.5, 0.0 } });
  const WallPatch patch = Remeshed(star, 15, [](Vertex, Vertex) { return true; });
  ExpectUpright(patch, 34.0);
}
