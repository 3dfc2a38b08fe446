/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/TissueMask.h"
#include "RunBackwards.h"
#include "Tessellation/CellMoments.h"
#include "Tessellation/CentroidFit.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Tessellation/SyntheticCells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace
{
using namespace tissue;
using SeedId = AnisotropicTessellation::SeedId;

/** A cube of 4, filled. */
TissueSamples
SampleCube(double step)
{
  const TissueGrid grid = MakeTissueGrid({ { { 0.0, 0.0, 0.0 } }, { { 4.0, 4.0, 4.0 } } }, step);
  return SampleMask({ grid, std::vector<std::uint8_t>(grid.NumberOfPoints(), 1) });
}

std::vector<Point>
CentroidsOf(const std::vector<SeedId> & cells, const TissueSamples & samples, std::size_t numberOfCells)
{
  std::vector<Point> centroids;
  for (const CellMoments & cell : MeasureCells(samples.points, cells, numberOfCells, samples.boxSize))
  {
    centroids.push_back(cell.mean);
  }
  return centroids;
}

double
MeanDistance(const std::vector<Point> & a, const std::vector<Point> & b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += Distance(a[i], b[i]);
  }
  return sum / static_cast<double>(a.size());
}

double
Agreement(const std::vector<SeedId> & a, const std::vector<SeedId> & b)
{
  std::size_t same = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    same += a[i] == b[i] ? 1 : 0;
  }
  return static_cast<double>(same) / static_cast<double>(a.size());
}

/** Without any. */
CellNeighbors
Alone(std::size_t numberOfCells)
{
  return CellNeighbors(numberOfCells);
}

/** Anisotropic cells of unlike sizes, their centroids, and what the fit and Voronoi cells make of these. */
struct Recovery
{
  TissueSamples       samples = SampleCube(0.1);
  std::vector<SeedId> truth;
  std::vector<Point>  points;
  std::vector<SeedId> voronoi;

  Recovery()
  {
    SyntheticCellOptions options;
    options.numberOfCells = 64;
    options.numberOfFounders = 64;
    options.anisotropy = 3.5;
    options.seed = 2;
    truth = AssignSamples(GrowSyntheticCells(samples, options, Execution()), samples);
    points = CentroidsOf(truth, samples, 64);
    voronoi = this->Assign(CentroidFit(points, Alone(64)));
  }

  std::vector<SeedId>
  Assign(const CentroidFit & fit) const
  {
    return AssignSamples(AnisotropicTessellation(fit.GetSeeds()), samples);
  }

  CentroidFit
  Fit(double relaxation, const Execution & execution = Execution()) const
  {
    CentroidFit fit(points, Alone(64));
    for (int sweep = 0; sweep < 20; ++sweep)
    {
      fit.Sweep(samples, relaxation, execution);
    }
    return fit;
  }
};
} // namespace

TEST(CentroidFit, LeavesARegularPackingAsItIs)
{
  std::vector<Point> points;
  for (int i = 0; i < 64; ++i)
  {
    points.push_back({ { i % 4 + 0.5, i / 4 % 4 + 0.5, i / 16 + 0.5 } });
  }
  CentroidFit fit(points, Alone(64));
  for (int sweep = 0; sweep < 5; ++sweep)
  {
    fit.Sweep(SampleCube(0.1), 0.0);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_LT(Distance(fit.GetSeeds()[i].position, points[i]), 1e-9) << i;
    const Metric identity{ { 1.0, 0.0, 0.0, 1.0, 0.0, 1.0 } };
    for (std::size_t k = 0; k < identity.size(); ++k)
    {
      EXPECT_NEAR(fit.GetSeeds()[i].metric[k], identity[k], 1e-9) << i;
    }
  }
}

TEST(CentroidFit, BringsTheCentroidsOntoThePointsAndCellsNearerToTheTruth)
{
  const Recovery recovery;
  const auto     fitted = recovery.Assign(recovery.Fit(0.0));
  EXPECT_GT(MeanDistance(CentroidsOf(recovery.voronoi, recovery.samples, 64), recovery.points), 0.05);
  EXPECT_LT(MeanDistance(CentroidsOf(fitted, recovery.samples, 64), recovery.points), 0.02);
  EXPECT_GT(Agreement(fitted, recovery.truth), Agreement(recovery.voronoi, recovery.truth) + 0.02);
}

TEST(CentroidFit, HoldsSeedsBackByTheRelaxation)
{
  const Recovery recovery;
  const auto     shift = [&recovery](double relaxation) {
    const CentroidFit  fit = recovery.Fit(relaxation);
    std::vector<Point> positions;
    for (const MetricSeed & seed : fit.GetSeeds())
    {
      positions.push_back(seed.position);
    }
    return MeanDistance(positions, recovery.points);
  };
  EXPECT_EQ(shift(1.0), 0.0);
  EXPECT_GT(shift(0.3), 0.01);
  EXPECT_GT(shift(0.0), 1.5 * shift(0.3));
}

TEST(CentroidFit, TakesTheShapeThatNeighborsHaveInCommon)
{
  // A lattice of cells twice as long in z, which are drawn out alike, and one point that is out of place.
  std::vector<Point> points;
  CellNeighbors      all(32);
  for (int i = 0; i < 32; ++i)
  {
    points.push_back({ { i % 4 + 0.5, i / 4 % 4 + 0.5, i / 16 * 2 + 1.0 } });
    for (std::size_t j = 0; j < 32; ++j)
    {
      if (j != static_cast<std::size_t>(i))
      {
        all[static_cast<std::size_t>(i)].push_back(j);
      }
    }
  }
  points[5][0] += 0.3;
  const auto ratioOf = [&](CellNeighbors neighbors, std::size_t cell) {
    CentroidFit fit(points, std::move(neighbors));
    for (int sweep = 0; sweep < 10; ++sweep)
    {
      fit.Sweep(SampleCube(0.1), 0.5);
    }
    const Metric & metric = fit.GetSeeds()[cell].metric;
    return std::pair<double, double>(metric[0] / metric[5], metric[3] / metric[0]);
  };
  EXPECT_GT(ratioOf(all, 5).first, 1.5);
  // Its own shape would tell it from the others more.
  EXPECT_LT(std::abs(std::log(ratioOf(all, 5).second)), std::abs(std::log(ratioOf(Alone(32), 5).second)));
}

TEST(CentroidFit, SendsTheSeedOfAnEmptyCellBackToItsPoint)
{
  const std::vector<Point> points{ { { 1.0, 2.0, 2.0 } }, { { 3.0, 2.0, 2.0 } }, { { 40.0, 2.0, 2.0 } } };
  CentroidFit              fit(points, Alone(3));
  fit.Sweep(SampleCube(0.2), 0.0);
  EXPECT_EQ(fit.GetSeeds()[2].position, points[2]);
}

TEST(CentroidFit, IsTheSameInAnyOrderOfItsParts)
{
  const Recovery    recovery;
  const CentroidFit a = recovery.Fit(0.0);
  const CentroidFit b = recovery.Fit(0.0, Execution(tissue_test::RunBackwards));
  for (std::size_t i = 0; i < 64; ++i)
  {
    EXPECT_EQ(a.GetSeeds()[i].position, b.GetSeeds()[i].position);
    EXPECT_EQ(a.GetSeeds()[i].metric, b.GetSeeds()[i].metric);
  }
}
