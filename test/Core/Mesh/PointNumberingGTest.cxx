/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallMeshOrder.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

TEST(PointNumbering, PointsComeInTheOrderGiven)
{
  const WallMesh       mesh = FourCells();
  const auto           n = static_cast<PointId>(mesh.points.size());
  std::vector<PointId> backwards;
  for (PointId p = n - 1; p >= 0; --p)
  {
    backwards.push_back(p);
  }
  WallMesh turned = mesh;
  TakePoints(turned, backwards);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const PointId p = mesh.triangles[t][i];
      EXPECT_EQ(turned.triangles[t][i], n - 1 - p);
      EXPECT_EQ(turned.points[n - 1 - p], mesh.points[p]);
      EXPECT_EQ(turned.numberOfCells[n - 1 - p], mesh.numberOfCells[p]);
    }
  }
}

TEST(PointNumbering, PointsOfLinesComeFirstAndThoseOfNoTriangleGo)
{
  WallMesh          mesh = RoundOrange(1);
  const std::size_t n = mesh.points.size();
  ASSERT_FALSE(std::is_sorted(mesh.numberOfCells.rbegin(), mesh.numberOfCells.rend()));
  mesh.points.insert(mesh.points.begin(), Point{ { 9.0, 9.0, 9.0 } });
  mesh.numberOfCells.insert(mesh.numberOfCells.begin(), CellsWithinWall);
  for (auto & triangle : mesh.triangles)
  {
    for (PointId & p : triangle)
    {
      ++p;
    }
  }
  PutLinePointsFirst(mesh);
  EXPECT_EQ(mesh.points.size(), n);
  ExpectSound(mesh, 3);
  EXPECT_TRUE(std::is_partitioned(
    mesh.numberOfCells.begin(), mesh.numberOfCells.end(), [](int cells) { return cells > CellsWithinWall; }));
}
