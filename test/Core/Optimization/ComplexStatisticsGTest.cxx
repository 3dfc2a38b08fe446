/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/ReferenceAdjacency.h"
#include "TestComplexes.h"
#include "TissueTessellationCore/Optimization/ComplexStatistics.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace tissue_test;

namespace
{
double
Degrees(double radians)
{
  return radians * 180.0 / std::acos(-1.0);
}

ComplexStatistics
StatisticsOf(const AdjacencyComplex & complex, const std::vector<Point> & centers, const ReferenceAdjacency * reference,
             const EnergyParameters & parameters)
{
  const auto tetrahedra = complex.GetTetrahedra();
  return ComputeStatistics(tetrahedra, AdjacencyTuples::Of(tetrahedra), centers, reference, parameters);
}

const std::vector<Point> CubeCorner{ NoPosition, { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
} // namespace

TEST(ComplexStatistics, OfTheRegularTetrahedron)
{
  const AdjacencyComplex   complex(5, FourSimplex());
  const auto               centers = RegularTetrahedron();
  const ReferenceAdjacency reference(JunctionsOf(complex, centers));
  const auto               statistics = StatisticsOf(complex, centers, &reference, {});
  EXPECT_DOUBLE_EQ(statistics.overlap.adjacency2, 1.0);
  EXPECT_DOUBLE_EQ(statistics.overlap.adjacency4, 1.0);
  EXPECT_NEAR(statistics.eccentricity, 0.0, 1e-12);
  EXPECT_NEAR(statistics.minimalDihedralAngle, Degrees(std::acos(1.0 / 3.0)), 1e-9);
  EXPECT_NEAR(statistics.maximalDihedralAngle, Degrees(std::acos(1.0 / 3.0)), 1e-9);
  // Each cell has four neighbours, the exterior among them, instead of 9 + 1.
  EXPECT_NEAR(statistics.neighborhoodError, 0.36, 1e-12);
  EXPECT_EQ(statistics.numberOfTetrahedra, 5u);
  EXPECT_EQ(statistics.numberOfEdges, 10u);
  EXPECT_EQ(statistics.numberOfInnerTetrahedra, 1u);
  EXPECT_EQ(statistics.numberOfInvertedTetrahedra, 0u);
  EXPECT_EQ(statistics.numberOfEpidermalCells, 4u);
}

TEST(ComplexStatistics, OfTheCornerOfACube)
{
  const AdjacencyComplex complex(5, FourSimplex());
  const auto             statistics = StatisticsOf(complex, CubeCorner, nullptr, {});
  const double           area = 1.5 + std::sqrt(3.0) / 2.0;
  EXPECT_NEAR(statistics.eccentricity, 1.0 - 6.0 * std::sqrt(3.0) / (area * area * area), 1e-12);
  EXPECT_NEAR(statistics.minimalDihedralAngle, Degrees(std::acos(1.0 / std::sqrt(3.0))), 1e-9);
  EXPECT_NEAR(statistics.maximalDihedralAngle, 90.0, 1e-9);
  EXPECT_EQ(statistics.overlap.adjacency2, 0.0) << "without a reference";
  EXPECT_EQ(statistics.overlap.adjacency4, 0.0) << "without a reference";
}

TEST(ComplexStatistics, CountsInvertedAndFlatTetrahedra)
{
  const AdjacencyComplex complex(5, FourSimplex());
  auto                   centers = CubeCorner;
  std::swap(centers[1], centers[2]);
  EXPECT_EQ(StatisticsOf(complex, centers, nullptr, {}).numberOfInvertedTetrahedra, 1u);
  centers[4] = { { 0.2, 0.2, 0 } };
  const auto flat = StatisticsOf(complex, centers, nullptr, {});
  EXPECT_EQ(flat.numberOfInvertedTetrahedra, 1u);
  EXPECT_NEAR(flat.eccentricity, 1.0, 1e-12);
}

TEST(ComplexStatistics, TellsInnerFromEpidermalCells)
{
  // A cell inside of four: 4 neighbours instead of 13; the others have five, the exterior counted, instead of 10.
  auto centers = RegularTetrahedron();
  centers.push_back({ { 0, 0, 0 } });
  const auto statistics = StatisticsOf(DelaunayComplex(centers), centers, nullptr, {});
  EXPECT_EQ(statistics.numberOfEpidermalCells, 4u);
  EXPECT_EQ(statistics.numberOfInnerTetrahedra, 4u);
  EXPECT_NEAR(statistics.neighborhoodError, (4 * 0.25 + 81.0 / 169.0) / 5.0, 1e-12);
}
