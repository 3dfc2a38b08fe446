/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/CellCorners.h"
#include "Dual/DualMesh.h"
#include "RandomMoves.h"
#include "TestComplexes.h"
#include "WallMeshChecks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace tissue_test;

namespace
{
DualMesh
PaperDual(const AdjacencyComplex & complex, const std::vector<Point> & centers)
{
  return Dualize(complex, ComputeCorners(complex, JunctionsOf(complex, centers), CornerRule::ProjectedCircumcenter));
}

/** Cells on a jittered cubic lattice of spacing 1. */
std::vector<Point>
JitteredLattice(int side)
{
  auto centers = RandomCenters(side * side * side, 1, 0.2);
  for (int i = 0; i < side * side * side; ++i)
  {
    const Point corner{ { double(i % side), double(i / side % side), double(i / side / side) } };
    centers[i + 1] = centers[i + 1] + corner;
  }
  return centers;
}
} // namespace

TEST(DualMesh, HasAWallForEachEdgeAndACornerForEachTetrahedron)
{
  const AdjacencyComplex complex(8, Bipyramid(5));
  std::vector<Point>     corners(complex.NumberOfTetrahedra());
  const DualMesh         dual = Dualize(complex, corners);
  EXPECT_EQ(dual.corners.size(), complex.NumberOfTetrahedra());
  ASSERT_EQ(dual.walls.size(), complex.NumberOfEdges());
  const auto tetrahedra = complex.GetTetrahedra();
  for (const DualMesh::Wall & wall : dual.walls)
  {
    EXPECT_EQ(wall.corners.size(), static_cast<std::size_t>(complex.FindEdge(wall.cells[0], wall.cells[1])->degree));
    for (const PointId corner : wall.corners)
    {
      const VertexQuadruple & t = tetrahedra[corner];
      EXPECT_EQ(std::count(t.begin(), t.end(), wall.cells[0]) + std::count(t.begin(), t.end(), wall.cells[1]), 2);
    }
  }
}

TEST(DualMesh, RefusesAWrongNumberOfCorners)
{
  const AdjacencyComplex complex(5, FourSimplex());
  EXPECT_THROW(Dualize(complex, std::vector<Point>(4)), std::invalid_argument);
}

TEST(DualMesh, OfARegularTetrahedronByHand)
{
  const auto             centers = RegularTetrahedron(); // of volume 8 / 3
  const AdjacencyComplex complex(5, FourSimplex());
  const DualMesh         dual = PaperDual(complex, centers);
  const WallMesh         mesh = TriangulateAsStars(dual);
  ASSERT_EQ(dual.walls.size(), 10u);
  EXPECT_EQ(mesh.points.size(), 5u + 10u);
  EXPECT_EQ(mesh.triangles.size(), 30u);
  ExpectInvariants(mesh, 5);
  // The corners at the barycentres of the four sides span the dual tetrahedron, a third as large in length.
  for (VertexId cell = 1; cell <= 4; ++cell)
  {
    EXPECT_NEAR(VolumeOf(mesh, cell), 8.0 / 3.0 / 27.0 / 4.0, 1e-12);
  }
  EXPECT_NEAR(VolumeOf(mesh, ExteriorVertex), -8.0 / 3.0 / 27.0, 1e-12) << "seen from outside";
}

TEST(DualMesh, StarsAreAroundTheMeanOfTheCorners)
{
  const auto     centers = RandomCenters(30, 2);
  const auto     complex = DelaunayComplex(centers);
  const DualMesh dual = PaperDual(complex, centers);
  const WallMesh mesh = TriangulateAsStars(dual);
  for (std::size_t w = 0; w < dual.walls.size(); ++w)
  {
    Point sum{ { 0, 0, 0 } };
    for (const PointId corner : dual.walls[w].corners)
    {
      sum = sum + dual.corners[corner];
    }
    const Point & center = mesh.points[dual.corners.size() + w];
    EXPECT_NEAR(Distance((1.0 / static_cast<double>(dual.walls[w].corners.size())) * sum, center), 0.0, 1e-12);
    EXPECT_EQ(mesh.numberOfCells[dual.corners.size() + w], CellsWithinWall);
  }
}

TEST(DualMesh, NormalsPointFromTheFirstCellToTheSecond)
{
  // With the circumcentres as corners the walls are those of the Voronoi diagram: plane, and perpendicular to the way
  // from cell to cell. Tetrahedra to the exterior have none.
  const auto         centers = RandomCenters(60, 5);
  const auto         complex = DelaunayComplex(centers);
  std::vector<Point> corners;
  for (const VertexQuadruple & t : complex.GetTetrahedra())
  {
    corners.push_back(
      t[0] == ExteriorVertex ? NoPosition : Circumcenter(centers[t[0]], centers[t[1]], centers[t[2]], centers[t[3]]));
  }
  const WallMesh     mesh = TriangulateAsStars(Dualize(complex, corners));
  std::vector<Point> normals(mesh.walls.size(), Point{ { 0, 0, 0 } });
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & p = mesh.triangles[t];
    Point &      normal = normals[mesh.wallOfTriangle[t]];
    normal = normal + Cross(mesh.points[p[1]] - mesh.points[p[0]], mesh.points[p[2]] - mesh.points[p[0]]);
  }
  int checked = 0;
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    if (!std::isnan(normals[w][0]))
    {
      const Point way = centers[mesh.walls[w].cells[1]] - centers[mesh.walls[w].cells[0]];
      EXPECT_NEAR(Dot(normals[w], way), Norm(normals[w]) * Norm(way), 1e-9) << "wall " << w;
      ++checked;
    }
  }
  EXPECT_GT(checked, 100);
}

TEST(DualMesh, VolumesOfInnerCellsArePositiveAndAllFillTheTissue)
{
  // Cells of the surface may have none: the lowered surface cuts through the corners of the lattice.
  const auto     centers = JitteredLattice(5);
  const auto     complex = DelaunayComplex(centers);
  const WallMesh mesh = TriangulateAsStars(PaperDual(complex, centers));
  ExpectInvariants(mesh, complex.NumberOfVertices());
  double sum = 0.0;
  int    inner = 0;
  for (VertexId cell = 1; cell < complex.NumberOfVertices(); ++cell)
  {
    if (!complex.FindEdge(ExteriorVertex, cell))
    {
      EXPECT_GT(VolumeOf(mesh, cell), 0.0) << "cell " << cell;
      ++inner;
    }
    sum += VolumeOf(mesh, cell);
  }
  EXPECT_GE(inner, 27);
  EXPECT_NEAR(sum, -VolumeOf(mesh, ExteriorVertex), 1e-9);
}

TEST(DualMesh, InvariantsHoldForEveryValidComplex)
{
  const auto       centers = RandomCenters(60, 3);
  AdjacencyComplex complex = DelaunayComplex(centers);
  Random           random(3);
  Scramble(complex, LocalOperations(complex, centers, Legality::Combinatorial), 300, random);
  ExpectInvariants(TriangulateAsStars(PaperDual(complex, centers)), complex.NumberOfVertices());
}

TEST(DualMesh, DoesNotDependOnTheHistoryOfTheComplex)
{
  const auto             centers = RandomCenters(40, 4);
  const AdjacencyComplex fresh = DelaunayComplex(centers);
  AdjacencyComplex       used = fresh;
  const LocalOperations  operations(used, centers, Legality::Combinatorial);
  Random                 random(4);
  for (int done = 0; done < 100;)
  {
    if (const Proposal move = RandomMove(used, operations, random))
    {
      used.Apply(used.Apply(move.replacement));
      ++done;
    }
  }
  const WallMesh a = TriangulateAsStars(PaperDual(fresh, centers));
  const WallMesh b = TriangulateAsStars(PaperDual(used, centers));
  EXPECT_TRUE(a.points == b.points);
  EXPECT_TRUE(a.triangles == b.triangles);
}
