/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/AngleMending.h"
#include "Mesh/Crossings.h"
#include "TestWallMeshes.h"
#include "TissueTessellationCore/Common/Random.h"

#include <gtest/gtest.h>

#include <set>

using namespace tissue_test;

namespace
{
constexpr VertexId NumberOfVertices = 4; // of the orange

/** The first triangle of which all points are within a wall. */
Triangle
InnerTriangle(const WallMesh & mesh)
{
  return *std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle & t) {
    return std::all_of(t.begin(), t.end(), [&](PointId p) { return mesh.numberOfCells[p] == CellsWithinWall; });
  });
}

/** That all cells are spheres still, with the same walls and corners, and nothing crosses. */
void
ExpectMended(WallMesh & mesh)
{
  const auto wallsBefore = mesh.walls.size();
  const auto corners = std::count(mesh.numberOfCells.begin(), mesh.numberOfCells.end(), CellsAtCorner);
  ASSERT_FALSE(FindSharpPlaces(mesh, AngleLimits()).empty());
  EXPECT_EQ(MendAngles(mesh, AngleLimits()), 0);
  EXPECT_TRUE(FindSharpPlaces(mesh, AngleLimits()).empty());
  EXPECT_TRUE(FindCrossings(mesh).empty());
  EXPECT_TRUE(CheckCellSurfaces(mesh, NumberOfVertices).IsSound());
  EXPECT_EQ(std::count(mesh.numberOfCells.begin(), mesh.numberOfCells.end(), CellsAtCorner), corners);
  EXPECT_EQ(std::set<WallId>(mesh.wallOfTriangle.begin(), mesh.wallOfTriangle.end()).size(), wallsBefore);
}
} // namespace

TEST(AngleMending, LeavesASoundMeshAsItIs)
{
  const WallMesh before = RoundOrange(2);
  WallMesh       mesh = before;
  EXPECT_EQ(MendAngles(mesh, AngleLimits()), 0);
  EXPECT_EQ(mesh.points, before.points);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(AngleMending, OfAShortEdge)
{
  WallMesh       mesh = RoundOrange(2);
  const Triangle t = InnerTriangle(mesh);
  mesh.points[t[0]] = mesh.points[t[1]] + 1e-4 * (mesh.points[t[0]] - mesh.points[t[1]]);
  ExpectMended(mesh);
}

TEST(AngleMending, OfASliver)
{
  // A point on the edge opposite to it, but for a hair.
  WallMesh       mesh = RoundOrange(2);
  const Triangle t = InnerTriangle(mesh);
  const Point    middle = 0.5 * (mesh.points[t[1]] + mesh.points[t[2]]);
  mesh.points[t[0]] = middle + 0.01 * (mesh.points[t[0]] - middle);
  ExpectMended(mesh);
}

TEST(AngleMending, OfAFold)
{
  // A point beyond the edge opposite to it, so that its triangle lies on its neighbour.
  WallMesh       mesh = RoundOrange(2);
  const Triangle t = InnerTriangle(mesh);
  const Point    middle = 0.5 * (mesh.points[t[1]] + mesh.points[t[2]]);
  mesh.points[t[0]] = middle - 0.2 * (mesh.points[t[0]] - middle) + 0.02 * Normalized(middle);
  ASSERT_LT(MeasureWallAngles(mesh, NumberOfVertices).minimumDihedralAngle, 90.0);
  ExpectMended(mesh);
}

TEST(AngleMending, OfAWedgeBetweenWalls)
{
  // The axis goes towards one meridian's wall: the two cells beside it are thin there.
  WallMesh mesh = RoundOrange(2);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      const bool isInner = mesh.walls[mesh.wallOfTriangle[t]].cells[1] != ExteriorVertex;
      const bool isAtAxis = Norm(Point{ { mesh.points[p][0], mesh.points[p][1], 0 } }) < 0.3;
      if (isInner && isAtAxis && mesh.numberOfCells[p] == CellsWithinWall && mesh.points[p][1] > 0.0)
      {
        mesh.points[p][0] = 0.99 * std::abs(mesh.points[p][1]);
        mesh.points[p][1] = 0.02 * mesh.points[p][1];
      }
    }
  }
  ASSERT_TRUE(FindCrossings(mesh).empty());
  ExpectMended(mesh);
}

TEST(AngleMending, OfDisturbedMeshesIsNeverWorseAndTheSameEachTime)
{
  std::int64_t before = 0;
  std::int64_t left = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    Random   random(seed);
    WallMesh mesh = RoundOrange(2);
    for (std::size_t p = 2; p < mesh.points.size(); ++p)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        mesh.points[p][axis] += 0.12 * (random.Uniform() - 0.5);
      }
    }
    const auto crossings = FindCrossings(mesh).size();
    before += static_cast<std::int64_t>(FindSharpPlaces(mesh, AngleLimits()).size());
    WallMesh other = mesh;
    left += MendAngles(mesh, AngleLimits());
    MendAngles(other, AngleLimits());
    EXPECT_EQ(mesh.points, other.points);
    EXPECT_EQ(mesh.triangles, other.triangles);
    EXPECT_LE(FindCrossings(mesh).size(), crossings);
    EXPECT_TRUE(CheckCellSurfaces(mesh, NumberOfVertices).IsSound()) << seed;
  }
  EXPECT_GT(before, 20);
  EXPECT_LT(10 * left, before);
}
