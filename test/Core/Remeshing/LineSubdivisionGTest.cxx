/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallLines.h"
#include "Remeshing/LineSubdivision.h"
#include "Remeshing/WallEdgeLengths.h"
#include "TestWallMeshes.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
/** Cuts all lines for one length and checks each: number and lengths of its pieces, and that its ends are the same. */
WallMesh
Subdivide(WallMesh mesh, double edgeLength, VertexId numberOfCells, double tolerance)
{
  const auto     before = CollectWallLines(mesh);
  const WallMesh old = mesh;
  SubdivideLines(mesh, std::vector<double>(mesh.walls.size(), edgeLength));
  ExpectSound(mesh, numberOfCells);
  const auto lines = CollectWallLines(mesh);
  EXPECT_EQ(lines.size(), before.size());
  for (std::size_t i = 0; i < std::min(lines.size(), before.size()); ++i)
  {
    const auto & points = lines[i].points;
    const double length = LengthOf(before[i], old.points);
    const int    segments = NumberOfSegments(length, edgeLength);
    EXPECT_EQ(old.points[before[i].points.front()], mesh.points[points.front()]);
    EXPECT_EQ(old.points[before[i].points.back()], mesh.points[points.back()]);
    EXPECT_EQ(static_cast<int>(points.size()), segments + 1);
    for (std::size_t k = 1; k < points.size(); ++k)
    {
      EXPECT_NEAR(
        Distance(mesh.points[points[k - 1]], mesh.points[points[k]]), length / segments, tolerance * length / segments);
    }
  }
  return mesh;
}
} // namespace

TEST(LineSubdivision, StarsAreCutIntoEqualPieces)
{
  const WallMesh star = RandomTissue(20);
  for (const double edgeLength : { 10.0, 0.3, 0.1, 0.03 })
  {
    const WallMesh mesh = Subdivide(star, edgeLength, 20, 1e-9);
    const auto     corners =
      std::count(star.numberOfCells.begin(), star.numberOfCells.end(), static_cast<int>(CellsAtCorner));
    EXPECT_TRUE(std::equal(star.points.begin(), star.points.begin() + corners, mesh.points.begin()));
    for (VertexId cell = 1; cell <= 20; ++cell)
    {
      EXPECT_NEAR(tissue_test::VolumeOf(mesh, cell), tissue_test::VolumeOf(star, cell), 1e-12);
    }
  }
}

TEST(LineSubdivision, ShortLinesStayWhole)
{
  const WallMesh star = FourCells();
  const WallMesh mesh = Subdivide(star, 100.0, 4, 1e-9);
  EXPECT_EQ(mesh.points, star.points);
  EXPECT_EQ(mesh.triangles, star.triangles);
}

TEST(LineSubdivision, CutAgainWithMoreAndFewerPieces)
{
  // A polygon of few pieces is shorter than the curve: pieces of a cut polygon differ by what their bends cut off.
  WallMesh mesh = RoundOrange(3);
  for (const double edgeLength : { 0.1, 0.15, 0.25, 0.2, 0.07 })
  {
    mesh = Subdivide(mesh, edgeLength, 3, 0.05);
  }
}

TEST(LineSubdivision, AStraightLineStaysStraightWhenCutAgain)
{
  // The long thin triangles of a star hold some points back.
  WallMesh mesh = Subdivide(FourCells(), 0.2, 4, 1e-9);
  mesh = Subdivide(mesh, 0.3, 4, 0.3);
  mesh = Subdivide(mesh, 0.15, 4, 0.3);
  for (const WallLine & line : CollectWallLines(mesh))
  {
    EXPECT_NEAR(
      LengthOf(line, mesh.points), Distance(mesh.points[line.points.front()], mesh.points[line.points.back()]), 1e-9);
  }
}

TEST(LineSubdivision, TheSmallestEdgeLengthAtALineCounts)
{
  WallMesh            mesh = FourCells();
  const auto          before = CollectWallLines(mesh);
  std::vector<double> lengths(mesh.walls.size(), 0.5);
  lengths[3] = 0.1;
  SubdivideLines(mesh, lengths);
  const auto lines = CollectWallLines(mesh);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const bool   small = lines[i].walls[0] == 3 || lines[i].walls[1] == 3 || lines[i].walls[2] == 3;
    const double length = LengthOf(lines[i], mesh.points);
    EXPECT_EQ(static_cast<int>(lines[i].points.size()) - 1, NumberOfSegments(length, small ? 0.1 : 0.5));
  }
}
