/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/ExactPredicates.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace tissue_test;

namespace
{
/** The message of the refusal; empty where there is none. */
std::string
RefusalOf(const std::vector<Point> & centers)
{
  try
  {
    DelaunayTetrahedralization(centers);
  }
  catch (const std::invalid_argument & error)
  {
    return error.what();
  }
  return "";
}

testing::AssertionResult
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                              : testing::AssertionFailure() << "'" << text << "' lacks " << part;
}

/** A cube of cells on a lattice: many are cospherical and coplanar. */
std::vector<Point>
Lattice(int side)
{
  std::vector<Point> centers{ NoPosition };
  for (int i = 0; i < side * side * side; ++i)
  {
    centers.push_back({ { double(i % side), double(i / side % side), double(i / side / side) } });
  }
  return centers;
}

void
ExpectValidAndPositive(const std::vector<Point> & centers)
{
  const AdjacencyComplex complex = DelaunayComplex(centers);
  EXPECT_TRUE(FindViolations(complex).empty());
  for (const VertexQuadruple & t : complex.GetTetrahedra())
  {
    if (t[0] != ExteriorVertex)
    {
      EXPECT_EQ(Orientation(centers[t[0]], centers[t[1]], centers[t[2]], centers[t[3]]), 1);
    }
  }
}

/** Whether the same points in another order give the same tetrahedra. */
void
ExpectSameInAnyOrder(const std::vector<Point> & centers)
{
  const auto            expected = DelaunayTetrahedralization(centers);
  std::vector<VertexId> original(centers.size());
  for (std::size_t v = 0; v < original.size(); ++v)
  {
    original[v] = static_cast<VertexId>(v);
  }
  Random random(3);
  for (std::size_t v = original.size() - 1; v > 1; --v)
  {
    std::swap(original[v], original[1 + random.Index(v)]);
  }
  std::vector<Point> shuffled;
  for (const VertexId v : original)
  {
    shuffled.push_back(centers[v]);
  }
  std::vector<VertexQuadruple> found;
  for (VertexQuadruple t : DelaunayTetrahedralization(shuffled))
  {
    for (VertexId & v : t)
    {
      v = original[v];
    }
    found.push_back(Canonical(t));
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
}
} // namespace

TEST(DelaunayTetrahedralization, FourCellsAreOneTetrahedronAndFourToTheExterior)
{
  const auto       found = DelaunayTetrahedralization(RegularTetrahedron());
  AdjacencyComplex expected(5, FourSimplex());
  EXPECT_EQ(
    Orientation(RegularTetrahedron()[1], RegularTetrahedron()[2], RegularTetrahedron()[3], RegularTetrahedron()[4]), 1);
  EXPECT_EQ(found, expected.GetTetrahedra());
}

TEST(DelaunayTetrahedralization, RefusesFewerThanFourCells)
{
  EXPECT_TRUE(Contains(RefusalOf({}), "0 cells"));
  EXPECT_TRUE(Contains(RefusalOf({ NoPosition, { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }), "3 cells"));
}

TEST(DelaunayTetrahedralization, NamesTwoCellsAtTheSamePlace)
{
  auto centers = RandomCenters(20, 1);
  centers[17] = centers[5];
  EXPECT_TRUE(Contains(RefusalOf(centers), "vertices 5 and 17"));
}

TEST(DelaunayTetrahedralization, RefusesCoplanarAndCollinearCells)
{
  auto centers = RandomCenters(20, 1);
  for (Point & p : centers)
  {
    p[2] = 0.0;
  }
  EXPECT_TRUE(Contains(RefusalOf(centers), "all 20 cell centres are coplanar"));
  for (Point & p : centers)
  {
    p[1] = 0.0;
  }
  EXPECT_TRUE(Contains(RefusalOf(centers), "coplanar"));
}

TEST(DelaunayTetrahedralization, ValidAndPositiveOnRandomCells)
{
  ExpectValidAndPositive(RandomCenters(300, 4));
}

TEST(DelaunayTetrahedralization, ValidAndPositiveOnALattice)
{
  ExpectValidAndPositive(Lattice(4));
}

TEST(DelaunayTetrahedralization, TheOrderOfRandomCellsDoesNotMatter)
{
  ExpectSameInAnyOrder(RandomCenters(300, 5));
}

TEST(DelaunayTetrahedralization, TheOrderOfCosphericalCellsDoesNotMatter)
{
  ExpectSameInAnyOrder(Lattice(4));
}

TEST(DelaunayTetrahedralization, NoCellIsInsideACircumsphere)
{
  const auto centers = RandomCenters(60, 6);
  const auto radius = [&](const Point & center, VertexId v) { return Distance(center, centers[v]); };
  for (const VertexQuadruple & t : DelaunayTetrahedralization(centers))
  {
    if (t[0] == ExteriorVertex)
    {
      continue;
    }
    const Point  center = Circumcenter(centers[t[0]], centers[t[1]], centers[t[2]], centers[t[3]]);
    const double limit = radius(center, t[0]) * (1.0 - 1e-9);
    for (VertexId v = 1; v < static_cast<VertexId>(centers.size()); ++v)
    {
      EXPECT_GE(radius(center, v), limit);
    }
  }
}
