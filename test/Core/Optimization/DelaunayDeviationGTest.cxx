/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/LocalOperations.h"
#include "Optimization/DelaunayDeviation.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace tissue_test;

namespace
{
bool
TouchesExterior(const VertexQuadruple & t)
{
  return std::find(t.begin(), t.end(), ExteriorVertex) != t.end();
}

/** What a replacement adds; NaN where it changes the surface. */
double
Difference(const Replacement & replacement, const AdjacencyComplex & complex, const DelaunayDeviation & deviation)
{
  double difference = 0.0;
  for (const TetrahedronId id : replacement.removed)
  {
    const VertexQuadruple & t = complex.GetTetrahedron(id).vertices;
    difference -= TouchesExterior(t) ? NaN : deviation.Of(t);
  }
  for (const VertexQuadruple & t : replacement.created)
  {
    difference += deviation.Of(t);
  }
  return difference;
}
} // namespace

TEST(DelaunayDeviation, ByHand)
{
  const std::vector<Point> centers = RegularTetrahedron();
  const DelaunayDeviation  deviation(centers, { 0.0, 2.0, 2.0, 2.0, 2.0 });
  // Of volume 8 / 3, with six edges of squared length 8.
  EXPECT_NEAR(deviation.Of({ { 1, 2, 3, 4 } }), 8.0 / 3.0 / 8.0 * (6 * 8.0 / 20.0 / 4.0 - 0.45), 1e-12);
  EXPECT_EQ(deviation.Of({ { 0, 1, 3, 2 } }), 0.0);
  // Inverted, and its volume covered twice by others.
  EXPECT_NEAR(deviation.Of({ { 2, 1, 3, 4 } }), 8.0 / 3.0 / 8.0 * (6 * 8.0 / 20.0 / 4.0 + 0.45), 1e-12);
  // The mean square of these spacings is 4 too.
  const DelaunayDeviation uneven(centers, { 0.0, 1.0, 1.0, std::sqrt(7.0), std::sqrt(7.0) });
  EXPECT_NEAR(uneven.Of({ { 2, 1, 4, 3 } }), deviation.Of({ { 1, 2, 3, 4 } }), 1e-12);
}

TEST(DelaunayDeviation, LargeTetrahedraAreWorthLessThanNone)
{
  const std::vector<Point> centers = RegularTetrahedron();
  const double             edge = 2.0 * std::sqrt(2.0);
  const auto               of = [&](double spacing) {
    return DelaunayDeviation(centers, { 0.0, spacing, spacing, spacing, spacing }).Of({ { 1, 2, 3, 4 } });
  };
  EXPECT_LT(of(edge), 0.0);
  EXPECT_NEAR(of(edge / std::sqrt(1.5)), 0.0, 1e-12);
  EXPECT_GT(of(edge / 1.5), 0.0);
}

TEST(DelaunayDeviation, IsLeastForTheDelaunayTetrahedralization)
{
  const auto              centers = RandomCenters(200, 5);
  const AdjacencyComplex  complex = DelaunayComplex(centers);
  const DelaunayDeviation deviation(centers, std::vector<double>(centers.size(), 0.2));
  const LocalOperations   operations(complex, centers, Legality::Geometric);
  int                     number = 0;
  const auto              expectMore = [&](const Proposal & proposal) {
    const double difference = proposal ? Difference(proposal.replacement, complex, deviation) : NaN;
    if (!std::isnan(difference))
    {
      EXPECT_GT(difference, 0.0);
      ++number;
    }
  };
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; complex.IsAlive(id) && i < 4; ++i)
    {
      expectMore(operations.SwapTriangle(id, i));
    }
  }
  for (const AdjacencyComplex::Edge & edge : complex.GetEdges())
  {
    expectMore(operations.RemoveEdge(edge.vertices));
  }
  EXPECT_GT(number, 500);
}

TEST(DelaunayDeviation, DoesNotDependOnTheUnitOfLength)
{
  auto                    centers = RandomCenters(30, 6);
  const DelaunayDeviation deviation(centers, std::vector<double>(centers.size(), 0.3));
  const double            inUnits = deviation.Of({ { 1, 2, 3, 4 } });
  auto                    scaled = centers;
  for (Point & p : scaled)
  {
    p = 1e3 * p;
  }
  EXPECT_NEAR(
    DelaunayDeviation(scaled, std::vector<double>(centers.size(), 300.0)).Of({ { 1, 2, 3, 4 } }) / inUnits, 1.0, 1e-12);
}
