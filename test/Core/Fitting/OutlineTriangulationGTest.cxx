/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/OutlineTriangulation.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
constexpr int    Steps = 12;
constexpr double Width = 0.2;

Point
OnArch(double angle, double y)
{
  return { { std::cos(angle), y, std::sin(angle) } };
}

/** A wall along half a cylinder of radius 1 as a star, whose centre is off it. */
WallMesh
ArchAsStar()
{
  DualMesh       dual;
  DualMesh::Wall wall;
  wall.cells = { { 1, 2 } };
  const double step = std::acos(-1.0) / Steps;
  for (int i = 0; i <= Steps; ++i)
  {
    dual.corners.push_back(OnArch(step * i, 0.0));
  }
  for (int i = Steps; i >= 0; --i)
  {
    dual.corners.push_back(OnArch(step * i, Width));
  }
  wall.corners.resize(dual.corners.size());
  std::iota(wall.corners.begin(), wall.corners.end(), 0);
  dual.walls = { wall };
  return TriangulateAsStars(dual);
}

ImagePlaces
PlacesOnArch()
{
  ImagePlaces::Entries entries;
  for (int i = 0; i <= 200; ++i)
  {
    for (int k = 0; k <= 10; ++k)
    {
      const Point p = OnArch(std::acos(-1.0) * i / 200, Width * k / 10);
      entries.push_back({ 0, { { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) } } });
    }
  }
  return ImagePlaces(1, entries);
}

void
ExpectSame(const WallMesh & mesh, const WallMesh & before)
{
  EXPECT_EQ(mesh.points, before.points);
  EXPECT_EQ(mesh.triangles, before.triangles);
}
} // namespace

TEST(OutlineTriangulation, FollowsAnArch)
{
  const WallMesh star = ArchAsStar();
  WallMesh       mesh = star;
  EXPECT_EQ(TriangulateFarOutlines(mesh, PlacesOnArch(), 0.1), std::vector<WallId>{ 0 });
  ASSERT_EQ(mesh.points, std::vector<Point>(star.points.begin(), star.points.end() - 1));
  EXPECT_EQ(mesh.triangles.size(), mesh.points.size() - 2);
  double area = 0.0;
  for (const auto & t : mesh.triangles)
  {
    const Point & a = mesh.points[t[0]];
    const Point & b = mesh.points[t[1]];
    const Point & c = mesh.points[t[2]];
    const Point   middle = (1.0 / 3.0) * (a + b + c);
    EXPECT_NEAR(std::hypot(middle[0], middle[2]), 1.0, 0.01);
    EXPECT_LT(Dot(Cross(b - a, c - a), { { middle[0], 0.0, middle[2] } }), 0.0) << "turned over";
    area += TriangleArea(a, b, c);
  }
  EXPECT_NEAR(area, std::acos(-1.0) * Width, 0.01);
}

TEST(OutlineTriangulation, WallsNearTheirPlaceStay)
{
  const WallMesh star = ArchAsStar();
  WallMesh       mesh = star;
  EXPECT_TRUE(TriangulateFarOutlines(mesh, PlacesOnArch(), 1.0).empty());
  ExpectSame(mesh, star);
}

TEST(OutlineTriangulation, WallsWithoutPlacesStay)
{
  const WallMesh star = ArchAsStar();
  WallMesh       mesh = star;
  EXPECT_TRUE(TriangulateFarOutlines(mesh, ImagePlaces(1, {}), 0.1).empty());
  ExpectSame(mesh, star);
}

TEST(OutlineTriangulation, JoinsNoPointsThatAnotherWallHasToo)
{
  const WallMesh       before = Orange();
  ImagePlaces::Entries entries;
  for (std::size_t w = 0; w < before.walls.size(); ++w)
  {
    // Where the edge from pole to pole would be, which all walls have in common.
    entries.push_back({ w, { { 0.0F, 0.0F, 0.0F } } });
  }
  WallMesh mesh = before;
  EXPECT_EQ(TriangulateFarOutlines(mesh, ImagePlaces(before.walls.size(), entries), 0.01).size(), 6u);
  ExpectSound(mesh, 3);
  EXPECT_EQ(mesh.triangles.size(), 12u);

  WallMesh backwards = before;
  TriangulateFarOutlines(backwards, ImagePlaces(before.walls.size(), entries), 0.01, Execution(RunBackwards));
  ExpectSame(backwards, mesh);
}
