/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/HeightField.h"
#include "TissueTessellationCore/Mesh/WallAngles.h"
#include "WallSheets.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
WallMesh
MakeSheet(int n)
{
  WallMesh mesh;
  AddSheet(mesh, n, 0.0);
  return mesh;
}

bool
IsHeightField(const WallMesh & mesh)
{
  return tissue::IsHeightField(mesh, 0, mesh.triangles.size());
}
} // namespace

TEST(HeightField, IsAFlatWallAndASlightlyBentOne)
{
  WallMesh mesh = MakeSheet(4);
  EXPECT_TRUE(IsHeightField(mesh));
  for (Point & p : mesh.points)
  {
    p[2] = 0.1 * p[0] * p[0];
  }
  EXPECT_TRUE(IsHeightField(mesh));
  // From whatever side it is seen, and without knowing which points are on its rim.
  for (Point & p : mesh.points)
  {
    p = { { p[2] + 1e6, p[0], p[1] } };
  }
  mesh.numberOfCells.clear();
  EXPECT_TRUE(IsHeightField(mesh));
}

TEST(HeightField, IsNoFoldedRolledOrClosedWall)
{
  WallMesh folded = MakeSheet(4);
  folded.points[12] = { { 3.5, 2.0, 0.0 } };
  EXPECT_FALSE(IsHeightField(folded));

  WallMesh rolled = MakeSheet(4);
  for (Point & p : rolled.points)
  {
    p = { { std::sin(1.2 * p[0]), p[1], std::cos(1.2 * p[0]) } };
  }
  EXPECT_FALSE(IsHeightField(rolled));

  WallMesh tetrahedron;
  tetrahedron.points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  tetrahedron.triangles = { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } }, { { 0, 3, 2 } } };
  EXPECT_FALSE(IsHeightField(tetrahedron));
}

TEST(HeightField, IsNoRampThatWindsOverItself)
{
  // Steps about an axis, once and a half around: all triangles face upwards, and the last lie over the first.
  WallMesh mesh;
  for (int i = 0; i <= 12; ++i)
  {
    const double angle = 3.0 * 3.14159265358979 * i / 12.0;
    mesh.points.push_back({ { std::cos(angle), std::sin(angle), 0.05 * i } });
    mesh.points.push_back({ { 2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.05 * i } });
  }
  for (PointId i = 0; i < 24; i += 2)
  {
    mesh.triangles.push_back({ { i, i + 1, i + 2 } });
    mesh.triangles.push_back({ { i + 1, i + 3, i + 2 } });
  }
  EXPECT_FALSE(IsHeightField(mesh));
}

TEST(HeightField, HasNoCrossingsAndNoSharpFolds)
{
  Random random(3);
  int    count = 0;
  for (int i = 0; i < 300; ++i)
  {
    WallMesh mesh = MakeSheet(3);
    Shake(mesh, 0.003 * i, random);
    if (IsHeightField(mesh))
    {
      ++count;
      EXPECT_TRUE(FindCrossingsOneByOne(mesh).empty());
      EXPECT_GT(MeasureWallAngles(mesh, 1).minimumDihedralAngle, LeastFoldOfHeightField);
    }
  }
  EXPECT_GT(count, 50);
  EXPECT_LT(count, 250);
}
