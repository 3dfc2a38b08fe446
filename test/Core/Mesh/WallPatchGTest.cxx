/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallPatch.h"
#include "TissueTessellationCore/Common/Random.h"
#include "WallMeshChecks.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
using Vertex = WallPatch::Vertex;
using HalfEdge = WallPatch::HalfEdge;

/** A regular polygon around its middle, vertex n. */
WallPatch
Star(int n)
{
  std::vector<Point>                 points;
  std::vector<std::array<Vertex, 3>> triangles;
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / n;
    points.push_back({ { std::cos(angle), std::sin(angle), 0.0 } });
    triangles.push_back({ { n, i, (i + 1) % n } });
  }
  points.push_back({ { 0.0, 0.0, 0.0 } });
  return WallPatch(points, triangles, n);
}

/** A disk with the polygon as its outline, and links that agree. */
void
ExpectDisk(const WallPatch & patch)
{
  tissue_test::Triangles triangles;
  for (HalfEdge h = 0; h < patch.EndOfHalfEdges(); ++h)
  {
    if (!patch.IsAlive(h))
    {
      continue;
    }
    if (h % 3 == 0)
    {
      triangles.push_back({ { patch.From(h), patch.To(h), patch.Opposite(h) } });
    }
    if (patch.Twin(h) != WallPatch::None)
    {
      ASSERT_EQ(patch.Twin(patch.Twin(h)), h);
      ASSERT_EQ(patch.From(patch.Twin(h)), patch.To(h));
      ASSERT_EQ(patch.To(patch.Twin(h)), patch.From(h));
    }
  }
  long euler = 0;
  EXPECT_EQ(tissue_test::CheckSurface(triangles, euler), static_cast<std::size_t>(patch.OutlineSize()));
  EXPECT_EQ(euler, 1);
  int interior = 0;
  for (Vertex v = 0; v < patch.EndOfVertices(); ++v)
  {
    if (patch.HasVertex(v))
    {
      ASSERT_EQ(patch.From(patch.Leaving(v)), v);
      ASSERT_EQ(patch.Twin(patch.Leaving(v)) == WallPatch::None, v < patch.OutlineSize());
      std::ptrdiff_t around = 0;
      patch.ForEachAround(v, [&](HalfEdge) { ++around; });
      ASSERT_EQ(around, std::count_if(triangles.begin(), triangles.end(), [v](const auto & t) {
                  return t[0] == v || t[1] == v || t[2] == v;
                }));
      interior += v >= patch.OutlineSize() ? 1 : 0;
    }
  }
  EXPECT_EQ(patch.NumberOfInteriorVertices(), interior);
}
} // namespace

TEST(WallPatch, SplitFlipAndCollapseUndoEachOther)
{
  WallPatch      patch = Star(6);
  const HalfEdge spoke = patch.Leaving(6);
  const Vertex   middle = patch.Split(spoke, { { 0.5, 0.0, 0.0 } });
  ExpectDisk(patch);
  EXPECT_TRUE(patch.AreJoined(middle, 6));
  EXPECT_EQ(patch.NumberOfInteriorVertices(), 2);
  const HalfEdge back = patch.Leaving(middle);
  ASSERT_TRUE(patch.CanCollapse(back));
  patch.Collapse(back);
  ExpectDisk(patch);
  patch.Compact();
  ExpectDisk(patch);
  EXPECT_EQ(patch.Triangles().size(), 6u);
}

TEST(WallPatch, FlipJoinsTheOtherTwo)
{
  WallPatch      patch = Star(6);
  const HalfEdge spoke = patch.Leaving(6);
  const Vertex   end = patch.To(spoke);
  const Vertex   left = patch.Opposite(spoke);
  const Vertex   right = patch.Opposite(patch.Twin(spoke));
  EXPECT_FALSE(patch.AreJoined(left, right));
  patch.Flip(spoke);
  ExpectDisk(patch);
  EXPECT_TRUE(patch.AreJoined(left, right));
  EXPECT_FALSE(patch.AreJoined(6, end));
}

TEST(WallPatch, TheLastPointOfATriangleCanGoAndNoneOfItsOutline)
{
  WallPatch patch = Star(3);
  EXPECT_FALSE(patch.CanCollapse(patch.Leaving(0)));
  ASSERT_TRUE(patch.CanCollapse(patch.Leaving(3)));
  patch.Collapse(patch.Leaving(3));
  ExpectDisk(patch);
  patch.Compact();
  EXPECT_EQ(patch.Triangles().size(), 1u);
}

TEST(WallPatch, StaysADiskOnARandomWalk)
{
  Random    random(1);
  WallPatch patch = Star(7);
  int       counts[3] = { 0, 0, 0 };
  for (int step = 0; step < 2000; ++step)
  {
    const auto h = static_cast<HalfEdge>(random.Uniform() * patch.EndOfHalfEdges());
    if (!patch.IsAlive(h) || patch.Twin(h) == WallPatch::None)
    {
      continue;
    }
    const int operation = static_cast<int>(random.Uniform() * 3.0);
    if (operation == 0 && patch.NumberOfInteriorVertices() < 20)
    {
      patch.Split(h, 0.5 * (patch.PointAt(patch.From(h)) + patch.PointAt(patch.To(h))));
    }
    else if (operation == 1 && !patch.AreJoined(patch.Opposite(h), patch.Opposite(patch.Twin(h))))
    {
      patch.Flip(h);
    }
    else if (operation == 2 && patch.CanCollapse(h))
    {
      patch.Collapse(h);
    }
    else
    {
      continue;
    }
    ++counts[operation];
    ExpectDisk(patch);
    if (step % 100 == 0)
    {
      patch.Compact();
      ExpectDisk(patch);
    }
  }
  EXPECT_GT(*std::min_element(counts, counts + 3), 50);
}
