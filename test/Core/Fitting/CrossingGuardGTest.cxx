/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CrossingGuard.h"
#include "Fitting/Untangling.h"
#include "Geometry/TriangleCrossing.h"

#include <gtest/gtest.h>

namespace
{
using tissue::Point;
using tissue::TrianglesCross;

/** A triangle in the plane z = 0, and one that the z-axis runs along, lifted by a height. */
tissue::WallMesh
MakeTwoTriangles(double height)
{
  tissue::WallMesh mesh;
  mesh.points = { { { -2, -2, 0 } },        { { 2, -2, 0 } },           { { 0, 3, 0 } },
                  { { 0, 0, height - 1 } }, { { 0.5, 0, height + 1 } }, { { -0.5, 0, height + 1 } } };
  mesh.triangles = { { { 0, 1, 2 } }, { { 3, 4, 5 } } };
  mesh.wallOfTriangle = { 0, 1 };
  mesh.walls.resize(2);
  mesh.numberOfCells.assign(6, tissue::CellsWithinWall);
  return mesh;
}
} // namespace

TEST(CrossingGuard, FindsTrianglesThatCross)
{
  EXPECT_EQ(tissue::FindCrossings(MakeTwoTriangles(0.0)), (std::vector<tissue::TrianglePair>{ { { 0, 1 } } }));
  EXPECT_TRUE(tissue::FindCrossings(MakeTwoTriangles(1.5)).empty());
  // A point on a triangle is in both.
  EXPECT_EQ(tissue::FindCrossings(MakeTwoTriangles(1.0)).size(), 1u);
}

TEST(CrossingGuard, FindsThoseOfSomeWallsAlone)
{
  const tissue::WallMesh mesh = MakeTwoTriangles(0.0);
  EXPECT_TRUE(tissue::FindCrossingsOfWalls(mesh, {}).empty());
  EXPECT_EQ(tissue::FindCrossingsOfWalls(mesh, { 1 }), tissue::FindCrossings(mesh));
}

TEST(CrossingGuard, SharedPointsAreNoCrossing)
{
  const std::vector<Point> points{ { { 0, 0, 0 } },  { { 2, 0, 0 } },      { { 0, 2, 0 } },
                                   { { 1, 1, 1 } },  { { 1, 1, -1 } },     { { 2, 2, 0 } },
                                   { { -1, 0, 0 } }, { { 0.5, 0.5, -1 } }, { { 0.5, 0.5, 1 } } };
  EXPECT_FALSE(TrianglesCross(points, { { 0, 1, 2 } }, { { 0, 2, 3 } })) << "an edge";
  EXPECT_FALSE(TrianglesCross(points, { { 0, 1, 2 } }, { { 0, 6, 3 } })) << "a point";
  EXPECT_FALSE(TrianglesCross(points, { { 0, 1, 2 } }, { { 1, 5, 3 } })) << "a point";
  EXPECT_TRUE(TrianglesCross(points, { { 0, 1, 2 } }, { { 0, 7, 8 } })) << "a point, and the edge opposite to it";
  EXPECT_TRUE(TrianglesCross(points, { { 0, 7, 8 } }, { { 0, 1, 2 } }));
}

TEST(CrossingGuard, TrianglesInOnePlaneCrossWhereTheyOverlap)
{
  const std::vector<Point> points{ { { 0, 0, 0 } },  { { 2, 0, 0 } }, { { 0, 2, 0 } },    { { -2, 0, 0 } },
                                   { { 0, -2, 0 } }, { { 2, 2, 0 } }, { { 0.5, 0.5, 0 } } };
  EXPECT_FALSE(TrianglesCross(points, { { 0, 1, 2 } }, { { 0, 3, 4 } })) << "opposite triangles of a flat star";
  EXPECT_TRUE(TrianglesCross(points, { { 0, 1, 2 } }, { { 6, 5, 3 } }));
  EXPECT_TRUE(TrianglesCross(points, { { 0, 1, 2 } }, { { 0, 5, 3 } })) << "with a shared point";
}

TEST(CrossingGuard, PointsStepBackAsFarAsTheyMust)
{
  const tissue::WallMesh before = MakeTwoTriangles(2.0);
  tissue::WallMesh       mesh = MakeTwoTriangles(0.0);
  // A third of the way leaves a gap of 0.4; all of it crosses.
  EXPECT_EQ(tissue::StepBackFromCrossings(mesh, before.points, { 0.3, 0.0 }), 3);
  EXPECT_TRUE(tissue::FindCrossings(mesh).empty());
  EXPECT_NEAR(mesh.points[3][2], 0.4, 1e-12);

  mesh = MakeTwoTriangles(0.0);
  tissue::StepBackFromCrossings(mesh, before.points, { 0.9, 0.0 });
  EXPECT_EQ(mesh.points, before.points);

  mesh = MakeTwoTriangles(1.5);
  EXPECT_EQ(tissue::StepBackFromCrossings(mesh, before.points, { 0.3, 0.0 }), 0);
  EXPECT_EQ(mesh.points, MakeTwoTriangles(1.5).points);
}

TEST(CrossingGuard, UntanglingPartsTriangles)
{
  tissue::WallMesh mesh = MakeTwoTriangles(0.9);
  EXPECT_EQ(tissue::Untangle(mesh, 50), 0);
  EXPECT_TRUE(tissue::FindCrossings(mesh).empty());
}
