/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallLines.h"
#include "Mesh/WallPatch.h"
#include "Mesh/WallPieces.h"
#include "Remeshing/LineSubdivision.h"
#include "Remeshing/WallEdgeLengths.h"
#include "Remeshing/WallRemeshing.h"
#include "TestWallMeshes.h"
#include "TissueTessellationCore/Geometry/TriangleQuality.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
std::vector<double>
AllOf(const WallMesh & mesh, double edgeLength)
{
  return std::vector<double>(mesh.walls.size(), edgeLength);
}

/** Cells of a body-centred lattice, moved at random. */
WallMesh
LatticeTissue(int side)
{
  std::vector<Point> centers = RandomCenters(2 * side * side * side, 1, 0.4);
  for (std::size_t i = 1; i < centers.size(); ++i)
  {
    const auto   k = static_cast<int>(i - 1) / 2;
    const double shift = i % 2 == 0 ? 0.5 : 0.0;
    centers[i] = centers[i] + Point{ { shift + k % side, shift + k / side % side, shift + k / (side * side) } };
  }
  return StarsOf(DelaunayComplex(centers), centers);
}

/** Cuts and remeshes with one edge length, and checks all that must not change. */
WallMesh
CutAndRemesh(WallMesh mesh, double edgeLength, VertexId numberOfCells)
{
  SubdivideLines(mesh, AllOf(mesh, edgeLength));
  const WallMesh cut = mesh;
  RemeshWalls(mesh, AllOf(mesh, edgeLength));
  ExpectSound(mesh, numberOfCells);
  const auto outlineSize = static_cast<std::size_t>(
    std::count_if(cut.numberOfCells.begin(), cut.numberOfCells.end(), [](int n) { return n > CellsWithinWall; }));
  EXPECT_TRUE(std::equal(cut.points.begin(), cut.points.begin() + outlineSize, mesh.points.begin()));
  EXPECT_TRUE(
    std::equal(cut.numberOfCells.begin(), cut.numberOfCells.begin() + outlineSize, mesh.numberOfCells.begin()));
  const auto before = CollectWallLines(cut);
  const auto after = CollectWallLines(mesh);
  EXPECT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i)
  {
    EXPECT_EQ(before[i].points, after[i].points);
    EXPECT_EQ(before[i].walls, after[i].walls);
  }
  return mesh;
}

/** The area of each wall by its normals' parts along `normals`: that of the triangles if none is tilted or turned. */
std::vector<double>
AreasAlong(const WallMesh & mesh, const std::vector<Point> & normals)
{
  std::vector<double> areas(mesh.walls.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & p = mesh.triangles[t];
    const Point  cross = Cross(mesh.points[p[1]] - mesh.points[p[0]], mesh.points[p[2]] - mesh.points[p[0]]);
    EXPECT_NEAR(Dot(cross, normals[mesh.wallOfTriangle[t]]), Norm(cross), 1e-9) << "triangle " << t;
    areas[mesh.wallOfTriangle[t]] += 0.5 * Norm(cross);
  }
  return areas;
}

/** Normals of the walls' first triangles. */
std::vector<Point>
NormalsOf(const WallMesh & mesh)
{
  std::vector<Point> normals(mesh.walls.size());
  for (std::size_t t = mesh.triangles.size(); t-- > 0;)
  {
    const auto & p = mesh.triangles[t];
    normals[mesh.wallOfTriangle[t]] =
      Normalized(Cross(mesh.points[p[1]] - mesh.points[p[0]], mesh.points[p[2]] - mesh.points[p[0]]));
  }
  return normals;
}
} // namespace

TEST(WallRemeshing, FlatTriangularWallsStayFlatAndWhole)
{
  const WallMesh star = FourCells();
  for (const double edgeLength : { 10.0, 1.0, 0.3, 0.1 })
  {
    const WallMesh mesh = CutAndRemesh(star, edgeLength, 4);
    const auto     before = AreasAlong(star, NormalsOf(star));
    const auto     after = AreasAlong(mesh, NormalsOf(star));
    for (std::size_t w = 0; w < star.walls.size(); ++w)
    {
      EXPECT_NEAR(after[w], before[w], 1e-9 * before[w]);
    }
  }
}

TEST(WallRemeshing, LongEdgesMakeOneTriangleOfATriangularWall)
{
  EXPECT_EQ(CutAndRemesh(FourCells(), 100.0, 4).triangles.size(), 10u);
}

TEST(WallRemeshing, LongThinWalls)
{
  for (const double thickness : { 0.3, 0.1, 0.03 })
  {
    const WallMesh star = FourCells({ { 10.0, 1.0, thickness } });
    const WallMesh mesh = CutAndRemesh(star, 0.5, 4);
    const auto     before = AreasAlong(star, NormalsOf(star));
    const auto     after = AreasAlong(mesh, NormalsOf(star));
    for (std::size_t w = 0; w < star.walls.size(); ++w)
    {
      EXPECT_NEAR(after[w], before[w], 1e-9 * before[w]);
    }
  }
}

TEST(WallRemeshing, WallsOfTwoCornersGetNoChordOfALine)
{
  for (const double edgeLength : { 1.0, 0.5, 0.2 })
  {
    CutAndRemesh(RoundOrange(1), edgeLength, 3);
  }
  // The four lines between the poles have a point each, or they were one: six walls of two triangles.
  EXPECT_EQ(CutAndRemesh(Orange(), 10.0, 3).triangles.size(), 12u);
}

TEST(WallRemeshing, ACurvedWallStaysCurved)
{
  const WallMesh before = RoundOrange(3);
  WallMesh       mesh = CutAndRemesh(before, 0.2, 3);
  RemeshWalls(mesh, AllOf(mesh, 0.2));
  // An edge of length e lies e^2 / 8 below the sphere at its middle, a triangle e^2 / 6.
  double longest = 0.0;
  for (const auto & t : before.triangles)
  {
    longest = std::max(longest, Distance(before.points[t[0]], before.points[t[1]]));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (mesh.walls[mesh.wallOfTriangle[t]].cells[1] == ExteriorVertex)
    {
      const auto & corners = mesh.triangles[t];
      const Point  a = mesh.points[corners[0]];
      const Point  normal = Normalized(Cross(mesh.points[corners[1]] - a, mesh.points[corners[2]] - a));
      EXPECT_GT(Dot(normal, a), 0.8) << "turned or tilted";
      for (const PointId p : corners)
      {
        EXPECT_GT(Norm(mesh.points[p]), 1.0 - 2.0 * (longest * longest + 0.2 * 0.2) / 6.0);
      }
    }
  }
  for (VertexId cell = 1; cell <= 3; ++cell)
  {
    EXPECT_NEAR(VolumeOf(mesh, cell) / VolumeOf(before, cell), 1.0, 0.03);
  }
}

TEST(WallRemeshing, QualityAndNumberOfTriangles)
{
  const WallMesh star = LatticeTissue(4);
  for (const double wanted : { 100.0, 150.0, 250.0 })
  {
    WallMesh mesh = star;
    RemeshToNumberOfTriangles(mesh, wanted * 128);
    ExpectSound(mesh, 128);
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()) / 128.0, wanted, 0.03 * wanted);
    // The corners of this tissue's surface leave edges of a tenth of the others.
    const QualitySummary quality = SummarizeTriangleQuality(mesh.points, mesh.triangles);
    EXPECT_GE(quality.mean, wanted < 150.0 ? 0.86 : 0.90);
    EXPECT_GE(quality.fifthPercentile, wanted < 150.0 ? 0.4 : 0.65);
  }
}

TEST(WallRemeshing, EachWallHasItsOwnEdgeLength)
{
  const WallMesh      star = FourCells();
  std::vector<double> lengths = AllOf(star, 0.5);
  lengths[3] = 0.2;
  WallMesh mesh = star;
  SubdivideLines(mesh, lengths);
  RemeshWalls(mesh, lengths);
  ExpectSound(mesh, 4);
  const WallMesh even = CutAndRemesh(star, 0.5, 4);
  EXPECT_GT(TrianglesOfWall(mesh, 3).size(), 4 * TrianglesOfWall(even, 3).size());
}

TEST(WallRemeshing, TheOrderOfWorkDoesNotMatter)
{
  WallMesh forwards = RandomTissue(30);
  WallMesh backwards = forwards;
  RemeshToNumberOfTriangles(forwards, 30 * 150.0);
  RemeshToNumberOfTriangles(backwards, 30 * 150.0, {}, Execution(RunBackwards));
  EXPECT_EQ(forwards.points, backwards.points);
  EXPECT_EQ(forwards.triangles, backwards.triangles);
}

TEST(WallRemeshing, AWallIsReplacedAlone)
{
  WallMesh cut = RandomTissue(20);
  SubdivideLines(cut, AllOf(cut, 0.05));
  WallMesh mesh = cut;
  RemeshWalls(mesh, AllOf(cut, 0.05));
  const WallMesh remeshed = mesh;
  ReplaceWalls(mesh, cut, { 2, 5 });
  ExpectSound(mesh, 20);
  for (WallId w = 0; w < 8; ++w)
  {
    const WallMesh & source = w == 2 || w == 5 ? cut : remeshed;
    EXPECT_EQ(TrianglesOfWall(mesh, w).size(), TrianglesOfWall(source, w).size());
  }
  EXPECT_NE(TrianglesOfWall(cut, 2).size(), TrianglesOfWall(remeshed, 2).size());
}

TEST(WallRemeshing, RefusesLengthsThatAreNotOneForEachWallAndPositive)
{
  WallMesh mesh = FourCells();
  EXPECT_THROW(RemeshWalls(mesh, { 1.0 }), std::invalid_argument);
  EXPECT_THROW(RemeshWalls(mesh, AllOf(mesh, 0.0)), std::invalid_argument);
  EXPECT_THROW(SubdivideLines(mesh, { 1.0 }), std::invalid_argument);
  EXPECT_THROW(SubdivideLines(mesh, AllOf(mesh, NaN)), std::invalid_argument);
  EXPECT_THROW(ChooseEdgeLengths(mesh, 0.0), std::invalid_argument);
}

TEST(WallRemeshing, SubdividedWallsStayWhereTheyAre)
{
  const WallMesh star = LatticeTissue(3);
  WallMesh       mesh = star;
  SubdivideLines(mesh, AllOf(mesh, 0.2));
  const WallMesh cut = mesh;
  SubdivideWalls(mesh, AllOf(mesh, 0.1), Execution(RunBackwards));
  ExpectSound(mesh, 54);
  EXPECT_GT(mesh.triangles.size(), 2 * cut.triangles.size());
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(mesh);
  const std::vector<std::size_t> firstOfCut = FirstTrianglesOfWalls(cut);
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    const WallPatch before = MakePatch(cut, CutOutWall(cut, firstOfCut[w], firstOfCut[w + 1]));
    const WallPatch after = MakePatch(mesh, CutOutWall(mesh, first[w], first[w + 1]));
    EXPECT_NEAR(AreaOf(after), AreaOf(before), 1e-9 * AreaOf(before));
    EXPECT_EQ(after.NumberOfInteriorVertices(),
              std::max(1, NumberOfInteriorPoints(AreaOf(before), 0.1, before.OutlineSize())));
  }
}
