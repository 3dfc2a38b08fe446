/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Mesh/WallAngles.h"

#include "TestWallMeshes.h"
#include "TwoTriangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace tissue_test;

namespace
{
/** The least dihedral angle of a cell by its triangles turned outwards: 180 degrees less the turn of the normals where
 * the edge is convex. */
double
LeastDihedralByNormals(const WallMesh & mesh, VertexId cell)
{
  std::map<std::pair<PointId, PointId>, std::pair<Point, PointId>> normals; // and the apex
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    Triangle           p = mesh.triangles[t];
    if (cells[0] != cell && cells[1] != cell)
    {
      continue;
    }
    if (cells[1] == cell)
    {
      std::swap(p[1], p[2]);
    }
    const Point normal =
      Normalized(Cross(mesh.points[p[1]] - mesh.points[p[0]], mesh.points[p[2]] - mesh.points[p[0]]));
    for (int i = 0; i < 3; ++i)
    {
      normals[{ p[i], p[(i + 1) % 3] }] = { normal, p[(i + 2) % 3] };
    }
  }
  double least = 180.0;
  for (const auto & [edge, first] : normals)
  {
    const auto & second = normals.at({ edge.second, edge.first });
    const double turn = std::acos(std::clamp(Dot(first.first, second.first), -1.0, 1.0)) * 180.0 / std::acos(-1.0);
    const bool   isConvex = Dot(first.first, mesh.points[second.second] - mesh.points[edge.first]) < 0.0;
    least = std::min(least, isConvex ? 180.0 - turn : 180.0 + turn);
  }
  return least;
}
} // namespace

TEST(WallAngles, OfTriangles)
{
  EXPECT_NEAR(LeastAngle({ { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0.5, std::sqrt(0.75), 0 } }), 60.0, 1e-12);
  EXPECT_NEAR(LeastAngle({ { 0, 0, 0 } }, { { 0, 3, 0 } }, { { 0, 3, std::sqrt(3.0) } }), 30.0, 1e-12);
  EXPECT_NEAR(LeastAngle({ { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 1e-9, 0 } }), 0.0, 1e-6);
  EXPECT_EQ(LeastAngle({ { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 0, 0 } }), 0.0);
}

TEST(WallAngles, OfTwoTrianglesAtAnEdge)
{
  const Point a{ { 0, 0, 0 } };
  const Point b{ { 2, 0, 0 } };
  const Point flat{ { 1, 1, 0 } };
  EXPECT_NEAR(DihedralAngle(a, b, flat, { { 3, 0, 5 } }), 90.0, 1e-12);
  EXPECT_NEAR(DihedralAngle(a, b, flat, { { 0, -2, 0 } }), 180.0, 1e-12);
  EXPECT_NEAR(DihedralAngle(a, b, flat, { { 0, 1, 1e-9 } }), 1e-9 * 180.0 / std::acos(-1.0), 1e-15);
}

TEST(WallAngles, AreTheLeastOfEachCell)
{
  for (const WallMesh & mesh : { Orange(), RoundOrange(1), FourCells({ { 1, 1, 0.1 } }) })
  {
    const VertexId   cells = mesh.walls.size() == 6 ? 4 : 5;
    const WallAngles angles = MeasureWallAngles(mesh, cells);
    double           least = 180.0;
    EXPECT_EQ(angles.minimumDihedralOfCell[ExteriorVertex], 180.0);
    for (VertexId cell = 1; cell < cells; ++cell)
    {
      EXPECT_NEAR(angles.minimumDihedralOfCell[cell], LeastDihedralByNormals(mesh, cell), 1e-6);
      least = std::min(least, angles.minimumDihedralOfCell[cell]);
    }
    EXPECT_EQ(angles.minimumDihedralAngle, least);
  }
}

TEST(WallAngles, TellEdges)
{
  WallMesh mesh = MakeTwoTriangles(5.0);
  mesh.walls[0].cells = { { 1, ExteriorVertex } };
  mesh.walls[1].cells = { { 2, ExteriorVertex } };
  const WallAngles angles = MeasureWallAngles(mesh, 3);
  EXPECT_EQ(angles.shortestEdge, 1.0);
  EXPECT_EQ(angles.longestEdge, std::sqrt(29.0));
  EXPECT_EQ(angles.EdgeLengthRatio(), std::sqrt(29.0));
  EXPECT_EQ(MedianEdgeLength(mesh), angles.medianEdge);
  EXPECT_EQ(MeasureWallAngles({}, 1).EdgeLengthRatio(), 0.0);
}

TEST(WallAngles, SharpPlacesAreTheOnesBelowTheLimits)
{
  WallMesh mesh = RoundOrange(2);
  EXPECT_TRUE(FindSharpPlaces(mesh, AngleLimits()).empty());
  // A point goes nearly to a neighbour.
  const auto    t = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle & triangle) {
    return std::all_of(triangle.begin(), triangle.end(), [&](PointId p) { return mesh.numberOfCells[p] == 2; });
  });
  const PointId from = (*t)[0];
  const PointId to = (*t)[1];
  mesh.points[from] = mesh.points[to] + 0.01 * (mesh.points[from] - mesh.points[to]);
  const auto places = FindSharpPlaces(mesh, AngleLimits());
  const auto count = [&](SharpPlace::Kind kind) {
    return std::count_if(places.begin(), places.end(), [&](const SharpPlace & place) { return place.kind == kind; });
  };
  EXPECT_GE(count(SharpPlace::Kind::TriangleAngle), 2);
  ASSERT_EQ(count(SharpPlace::Kind::EdgeLength), 1);
  const auto edge = std::find_if(
    places.begin(), places.end(), [](const SharpPlace & p) { return p.kind == SharpPlace::Kind::EdgeLength; });
  EXPECT_EQ(edge->points, (Triangle{ { std::min(from, to), std::max(from, to), -1 } }));
  EXPECT_NEAR(edge->value, Distance(mesh.points[from], mesh.points[to]) / MedianEdgeLength(mesh), 1e-12);
  EXPECT_EQ(edge->wall, mesh.wallOfTriangle[t - mesh.triangles.begin()]);
}
