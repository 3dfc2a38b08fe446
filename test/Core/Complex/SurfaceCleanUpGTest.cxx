/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TestComplexes.h"
#include "TissueTessellationCore/Complex/SurfaceCleanUp.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
/** Cells on a jittered lattice of spacing 1 in the shape of an L: arms three cells thick and nine long. */
std::vector<Point>
LShape()
{
  Random             random(1);
  std::vector<Point> centers{ NoPosition };
  for (int z = 0; z < 3; ++z)
  {
    for (int y = 0; y < 9; ++y)
    {
      for (int x = 0; x < (y < 3 ? 9 : 3); ++x)
      {
        const double dx = 0.2 * random.Uniform();
        const double dy = 0.2 * random.Uniform();
        centers.push_back({ { x + dx, y + dy, z + 0.2 * random.Uniform() } });
      }
    }
  }
  return centers;
}

std::size_t
NumberOfOversizedTriangles(const AdjacencyComplex & complex, const std::vector<Point> & centers, double limit)
{
  std::size_t oversized = 0;
  for (const VertexQuadruple & t : complex.GetTetrahedra())
  {
    const bool isLong = Distance(centers[t[1]], centers[t[2]]) > limit ||
                        Distance(centers[t[2]], centers[t[3]]) > limit ||
                        Distance(centers[t[3]], centers[t[1]]) > limit;
    oversized += t[0] == ExteriorVertex && isLong ? 1 : 0;
  }
  return oversized;
}

/** Tetrahedra of cells with their barycentre well inside of the notch of the L. */
std::size_t
NumberInNotch(const AdjacencyComplex & complex, const std::vector<Point> & centers)
{
  std::size_t inside = 0;
  for (const VertexQuadruple & t : complex.GetTetrahedra())
  {
    const Point sum = centers[t[1]] + centers[t[2]] + centers[t[3]] + centers[t[0]]; // NaN with the exterior
    inside += sum[0] > 4 * 3.5 && sum[1] > 4 * 3.5 ? 1 : 0;
  }
  return inside;
}

SurfaceCleanUpParameters
Limit(double maximumEdgeLength)
{
  SurfaceCleanUpParameters parameters;
  parameters.maximumEdgeLength = maximumEdgeLength;
  return parameters;
}
} // namespace

TEST(SurfaceCleanUp, OpensTheNotchOfAnL)
{
  const auto        centers = LShape();
  AdjacencyComplex  complex = DelaunayComplex(centers);
  const std::size_t oversized = NumberOfOversizedTriangles(complex, centers, 2.0);
  ASSERT_GT(NumberInNotch(complex, centers), 10u) << "the convex hull spans the notch";
  const std::size_t          before = complex.NumberOfTetrahedra();
  const SurfaceCleanUpResult result = CleanSurface(complex, centers, Limit(2.0));
  EXPECT_EQ(NumberInNotch(complex, centers), 0u);
  // Recorded: 65 before, 14 after; those that stay have all their cells on the surface and no edge of degree three.
  EXPECT_LT(NumberOfOversizedTriangles(complex, centers, 2.0), oversized / 3);
  EXPECT_TRUE(FindViolations(complex).empty());
  EXPECT_GT(result.numberOfSwaps, 0u);
  EXPECT_GT(result.numberOfRemovals, 0u);
  // A swap makes two tetrahedra three, the removal of an edge of degree three makes three two.
  EXPECT_EQ(complex.NumberOfTetrahedra(), before + result.numberOfSwaps - result.numberOfRemovals);
  for (VertexId v = 1; v < complex.NumberOfVertices(); ++v)
  {
    EXPECT_GT(complex.NumberOfNeighbors(v), 3) << "no cell is lost";
  }
}

TEST(SurfaceCleanUp, FollowsTheLocalLengths)
{
  const auto             centers = LShape();
  const AdjacencyComplex delaunay = DelaunayComplex(centers);
  auto                   local = Limit(0.5);
  local.localLengths.assign(centers.size(), 4.0);
  AdjacencyComplex byLocal = delaunay;
  AdjacencyComplex byOne = delaunay;
  CleanSurface(byLocal, centers, local);
  CleanSurface(byOne, centers, Limit(2.0));
  EXPECT_EQ(byLocal.GetTetrahedra(), byOne.GetTetrahedra());
  // Long enough at one arm to allow every edge from it: the notch stays closed.
  for (std::size_t v = 1; v < centers.size(); ++v)
  {
    local.localLengths[v] = centers[v][1] > 2.9 ? 50.0 : 4.0;
  }
  AdjacencyComplex half = delaunay;
  CleanSurface(half, centers, local);
  EXPECT_GT(NumberInNotch(half, centers), 10u);
}

TEST(SurfaceCleanUp, LeavesAConvexTissueWithinTheLimitAlone)
{
  const auto       centers = RandomCenters(50, 1);
  AdjacencyComplex complex = DelaunayComplex(centers);
  const auto       before = complex.GetTetrahedra();
  const auto       result = CleanSurface(complex, centers, Limit(2.0)); // the diagonal is sqrt(3)
  EXPECT_EQ(result.numberOfSwaps + result.numberOfRemovals, 0u);
  EXPECT_EQ(complex.GetTetrahedra(), before);
}

TEST(SurfaceCleanUp, ASecondTimeFindsNothing)
{
  const auto       centers = LShape();
  AdjacencyComplex complex = DelaunayComplex(centers);
  CleanSurface(complex, centers, Limit(1.5));
  const auto result = CleanSurface(complex, centers, Limit(1.5));
  EXPECT_EQ(result.numberOfSwaps + result.numberOfRemovals, 0u);
}

TEST(SurfaceCleanUp, MedianNeighborDistanceByHand)
{
  JunctionSet junctions;
  EXPECT_EQ(MedianNeighborDistance(junctions), 0.0);
  junctions.cells.resize(5);
  for (int i = 1; i < 5; ++i)
  {
    junctions.cells[i].center = { { i * i * 1.0, 0, 0 } };
  }
  // Walls at the distances 3, 5, 7, and one to the exterior, which does not count.
  for (const VertexPair & cells :
       { VertexPair{ { 0, 1 } }, VertexPair{ { 1, 2 } }, VertexPair{ { 2, 3 } }, VertexPair{ { 3, 4 } } })
  {
    Wall wall;
    wall.cells = cells;
    junctions.walls.push_back(wall);
  }
  EXPECT_EQ(MedianNeighborDistance(junctions), 5.0);
}
