/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Statistics/OuterTriangles.h"

#include "TissueTessellationCore/Geometry/Vector.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace tissue;

int
Count(const std::vector<TrianglePlace> & places, TrianglePlace place)
{
  return static_cast<int>(std::count(places.begin(), places.end(), place));
}

/** The places of the triangles on the border of an image. */
std::vector<TrianglePlace>
Place(const WallMesh & mesh, const ImageGrid & grid, bool mayBeCut)
{
  std::vector<TrianglePlace> places = FindSurface(mesh);
  MarkCut(
    mesh, FindBorder(grid), [mayBeCut](VertexId cell) { return cell == 1 && mayBeCut; }, places);
  return places;
}
} // namespace

TEST(OuterTriangles, WallsOfTwoCellsAndOfVoidsAreWithin)
{
  // A void in the middle of a block of two cells.
  std::vector<VertexId> vertices(27, 1);
  std::fill(vertices.begin(), vertices.begin() + 9, 2);
  vertices[13] = ExteriorVertex;
  const WallMesh mesh = MakeVoxelWallMesh({ { 3, 3, 3 } }, vertices);
  const auto     places = FindSurface(mesh);
  EXPECT_EQ(Count(places, TrianglePlace::Surface), 6 * 9 * 2);
  EXPECT_EQ(Count(places, TrianglePlace::Within), 6 * 2 + 8 * 2);
}

TEST(OuterTriangles, OnTheBorderAreThoseInItsPlanes)
{
  // A cube of 4 voxels that fills the image but for two voxels at each end of x, in a grid that is turned and sheared
  // in no way but lies anywhere: x of the image is z of space.
  const WallMesh unturned = MakeVoxelWallMesh({ { 4, 4, 4 } }, std::vector<VertexId>(64, 1));
  WallMesh       mesh = unturned;
  for (Point & p : mesh.points)
  {
    p = { { 10.0 - 0.5 * p[2], 20.0 + 0.5 * p[1], 30.0 + 2.0 * (p[0] + 2.0) } };
  }
  ImageGrid grid;
  grid.size = { { 8, 4, 4 } };
  grid.origin = { { 9.75, 20.25, 31.0 } };
  grid.steps = { { { { 0, 0, 2 } }, { { 0, 0.5, 0 } }, { { -0.5, 0, 0 } } } };
  const auto places = Place(mesh, grid, true);
  EXPECT_EQ(Count(places, TrianglePlace::Cut), 4 * 32);
  EXPECT_EQ(Count(places, TrianglePlace::Surface), 2 * 32);
  for (std::size_t t = 0; t < places.size(); ++t)
  {
    const Triangle & triangle = unturned.triangles[t];
    const bool       isAtEnd = unturned.points[triangle[0]][0] == unturned.points[triangle[1]][0] &&
                         unturned.points[triangle[0]][0] == unturned.points[triangle[2]][0];
    EXPECT_EQ(places[t] == TrianglePlace::Surface, isAtEnd);
  }
  EXPECT_EQ(Count(Place(mesh, grid, false), TrianglePlace::Cut), 0);
  EXPECT_EQ(Count(Place(mesh, ImageGrid(), true), TrianglePlace::Cut), 0);
}

TEST(OuterTriangles, AcrossAnEdgeOfTwoPlanesTheyHavePointsOnBoth)
{
  const std::vector<CutPlane> planes{ { { { 1, 0, 0 } }, 1.0, 0.15 }, { { { 0, 1, 0 } }, 1.0, 0.15 } };
  WallMesh                    mesh;
  mesh.walls = { { { { 1, ExteriorVertex } } } };
  const auto add = [&mesh](const Point & a, const Point & b, const Point & c) {
    const auto first = static_cast<PointId>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), { a, b, c });
    mesh.triangles.push_back({ { first, first + 1, first + 2 } });
    mesh.wallOfTriangle.push_back(0);
  };
  add({ { 1, 0.5, 0 } }, { { 1, 0.5, 1 } }, { { 0.5, 1, 0 } });        // bevels the edge
  add({ { 1, 0.2, 0 } }, { { 0.9, 0.2, 0 } }, { { 0.95, 0.2, 0.1 } }); // near one, but across it
  add({ { 1, 0.5, 0 } }, { { 1, 0.5, 1 } }, { { 0.5, 0.8, 0 } });      // has a point far from both
  std::vector<TrianglePlace> places(3, TrianglePlace::Surface);
  MarkCut(
    mesh, planes, [](VertexId) { return true; }, places);
  EXPECT_EQ(places, (std::vector<TrianglePlace>{ TrianglePlace::Cut, TrianglePlace::Surface, TrianglePlace::Surface }));
}
