/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/WallFitting.h"
#include "FourCellBall.h"
#include "Mesh/Crossings.h"
#include "TestWallMeshes.h"
#include "Mesh/WallMeasures.h"
#include "VoxelTissue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace tissue_test;

namespace
{
constexpr std::size_t NumberOfCorners = 5;
constexpr std::size_t NumberOfWalls = 10;

/** The ball of four cells, its walls fitted to its image. */
struct FittedBall
{
  LabelVolume           volume = MakeVolume();
  JunctionSet           junctions = JunctionsOf(volume);
  WallFittingStatistics statistics;
  WallMesh              mesh;

  explicit FittedBall(double trianglesPerCell, const Execution & execution = Execution(), int cornerLeftOut = -1)
  {
    std::vector<double> volumes;
    for (const Cell & cell : junctions.cells)
    {
      volumes.push_back(cell.volume);
    }
    ImageDual dual{ Dualize(MakeComplex(), TrueCorners()), std::vector<bool>(NumberOfCorners, true) };
    if (cornerLeftOut >= 0)
    {
      dual.isInImage[static_cast<std::size_t>(cornerLeftOut)] = false;
    }
    const std::vector<VertexId> inOrder{ 0, 1, 2, 3, 4 };
    mesh = FitWalls(dual, { volume, volume, inOrder, volumes, inOrder }, trianglesPerCell, &statistics, execution);
  }
};
} // namespace

TEST(WallFitting, CornersComeFirstInTheOrderOfTheTetrahedra)
{
  const std::vector<Point> expected = TrueCorners();
  ASSERT_EQ(expected.size(), NumberOfCorners);
  for (const double trianglesPerCell : { 0.0, 60.0 })
  {
    const FittedBall ball(trianglesPerCell);
    for (std::size_t i = 0; i < ball.mesh.points.size(); ++i)
    {
      EXPECT_EQ(ball.mesh.numberOfCells[i] == CellsAtCorner, i < NumberOfCorners) << i;
    }
    for (std::size_t i = 0; i < NumberOfCorners; ++i)
    {
      // The corners of stars are farther out: few flat triangles have the volume of a ball.
      const Point & corner = ball.mesh.points[i];
      const auto    nearest = std::min_element(expected.begin(), expected.end(), [&](const Point & a, const Point & b) {
        return Distance(a, corner) < Distance(b, corner);
      });
      EXPECT_EQ(static_cast<std::size_t>(nearest - expected.begin()), i);
      EXPECT_TRUE(trianglesPerCell == 0.0 || Distance(corner, expected[i]) < VoxelLength) << i;
    }
  }
}

TEST(WallFitting, WithoutANumberOfTrianglesTheWallsAreStars)
{
  // All walls have three corners: three triangles around each centre.
  const FittedBall ball(0.0);
  EXPECT_EQ(ball.mesh.walls.size(), NumberOfWalls);
  EXPECT_EQ(ball.mesh.triangles.size(), 3 * NumberOfWalls);
  EXPECT_EQ(ball.mesh.points.size(), NumberOfCorners + NumberOfWalls);
  ExpectSound(ball.mesh, 4);
}

TEST(WallFitting, ApproachesTheWantedNumberOfTriangles)
{
  for (const double trianglesPerCell : { 60.0, 240.0 })
  {
    const FittedBall ball(trianglesPerCell);
    EXPECT_NEAR(static_cast<double>(ball.mesh.triangles.size()) / (4.0 * trianglesPerCell), 1.0, 0.15);
    ExpectSound(ball.mesh, 4);
  }
}

TEST(WallFitting, CellsHaveTheirVolumesAndNothingCrosses)
{
  const FittedBall          ball(120.0);
  const std::vector<double> volumes = ComputeVolumes(ball.mesh, 5);
  for (std::size_t v = 1; v < 5; ++v)
  {
    EXPECT_NEAR(volumes[v] / ball.junctions.cells[v].volume, 1.0, 1e-6);
  }
  EXPECT_TRUE(FindCrossings(ball.mesh).empty());
  EXPECT_EQ(ball.statistics.crossingPairs, 0);
  EXPECT_EQ(ball.statistics.unfittedCorners, 0);
  EXPECT_EQ(ball.statistics.unfittedCornersOfCell, std::vector<std::int32_t>(5, 0));
}

TEST(WallFitting, WallsAreWhereTheCellsMeet)
{
  const FittedBall         ball(120.0);
  const std::vector<Point> centers = RegularTetrahedron();
  double                   sum = 0.0;
  for (std::size_t t = 0; t < ball.mesh.triangles.size(); ++t)
  {
    const VertexPair & cells = ball.mesh.walls[ball.mesh.wallOfTriangle[t]].cells;
    for (const PointId p : ball.mesh.triangles[t])
    {
      // The plane between two centres contains the origin, as they are as far from it.
      const Point & at = ball.mesh.points[p];
      const double  distance =
        cells[1] == ExteriorVertex ? Norm(at) - Radius : Dot(at, Normalized(centers[cells[0]] - centers[cells[1]]));
      sum += std::abs(distance) / (3.0 * static_cast<double>(ball.mesh.triangles.size()));
      EXPECT_LT(std::abs(distance), 1.5 * VoxelLength);
    }
  }
  EXPECT_LT(sum, 0.3 * VoxelLength);
}

TEST(WallFitting, CornersThatTheImageHasNotAreCounted)
{
  const auto       tetrahedra = MakeComplex().GetTetrahedra();
  const FittedBall ball(0.0, Execution(), 4);
  EXPECT_EQ(ball.statistics.unfittedCorners, 1);
  std::vector<std::int32_t> expected(5, 0);
  for (const VertexId v : tetrahedra[4])
  {
    expected[v] = 1;
  }
  EXPECT_EQ(ball.statistics.unfittedCornersOfCell, expected);
}

TEST(WallFitting, IsTheSameEachTimeAndInAnyOrderOfWork)
{
  const FittedBall first(60.0);
  const FittedBall second(60.0);
  const FittedBall backwards(60.0, Execution(RunBackwards));
  EXPECT_EQ(first.mesh.points, second.mesh.points);
  EXPECT_EQ(first.mesh.points, backwards.mesh.points);
  EXPECT_EQ(first.mesh.triangles, backwards.mesh.triangles);
}

TEST(WallFitting, ReportsProgressAndStopsOnRequest)
{
  std::vector<double> fractions;
  FittedBall(60.0, Execution({}, [&fractions](double fraction) {
               fractions.push_back(fraction);
               return true;
             }));
  ASSERT_GT(fractions.size(), 3u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GE(fractions.front(), 0.0);
  EXPECT_LE(fractions.back(), 1.0);

  int calls = 0;
  EXPECT_THROW(FittedBall(60.0, Execution({}, [&calls](double) { return ++calls < 3; })), Aborted);
  EXPECT_EQ(calls, 3);
}
