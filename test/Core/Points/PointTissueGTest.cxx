/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/TissueMask.h"
#include "Tessellation/CellMoments.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Points/PointTissue.h"
#include "TissueTessellationCore/Tessellation/SyntheticCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using namespace tissue;

const Box Cube{ { { 0.0, 0.0, 0.0 } }, { { 6.0, 6.0, 6.0 } } };

std::vector<Point>
Lattice()
{
  std::vector<Point> points;
  for (int i = 0; i < 216; ++i)
  {
    points.push_back({ { i % 6 + 0.5, i / 6 % 6 + 0.5, i / 36 + 0.5 } });
  }
  return points;
}

/** The centroids of 216 anisotropic cells of the cube. */
std::vector<Point>
CentroidsOfCells()
{
  const TissueGrid     grid = MakeTissueGrid(Cube, 0.1);
  const TissueSamples  samples = SampleMask({ grid, std::vector<std::uint8_t>(grid.NumberOfPoints(), 1) });
  SyntheticCellOptions options;
  options.numberOfCells = 216;
  options.numberOfFounders = 27;
  const auto         cells = AssignSamples(GrowSyntheticCells(samples, options, Execution()), samples);
  std::vector<Point> points;
  for (const CellMoments & cell : MeasureCells(samples.points, cells, 216, samples.boxSize))
  {
    points.push_back(cell.mean);
  }
  return points;
}

/** Of the inner points from the centroids of their cells. */
double
MeanDistance(const std::vector<Point> & points)
{
  const TissueGrid   grid = MakePointGrid(points, Cube, 500);
  const auto         labels = EstimateTissue(points, grid).labels;
  std::vector<Point> sums(points.size(), Point{ { 0.0, 0.0, 0.0 } });
  std::vector<int>   counts(points.size(), 0);
  for (std::int32_t z = 0; z < grid.size[2]; ++z)
  {
    for (std::int32_t y = 0; y < grid.size[1]; ++y)
    {
      for (std::int32_t x = 0; x < grid.size[0]; ++x)
      {
        const std::int32_t label = labels[grid.Offset(x, y, z)];
        if (label > 0)
        {
          sums[label - 1] = sums[label - 1] + grid.Position(x, y, z);
          ++counts[label - 1];
        }
      }
    }
  }
  double sum = 0.0;
  int    count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_GT(counts[i], 0) << i;
    const Point & p = points[i];
    if (std::min({ p[0], p[1], p[2] }) > 1.5 && std::max({ p[0], p[1], p[2] }) < 4.5)
    {
      sum += Distance((1.0 / counts[i]) * sums[i], p);
      ++count;
    }
  }
  return sum / count;
}
} // namespace

TEST(PointTissue, OfALatticeThatItsBoxCutsHasItsVolumes)
{
  // The outer cells are 0.7 thick: walls halfway between the points would be 0.075 off.
  const double       outer = 0.65;
  std::vector<Point> points = Lattice();
  for (Point & p : points)
  {
    for (double & value : p)
    {
      value = std::clamp(value, outer, 6.0 - outer);
    }
  }
  const TissueGrid grid = MakeTissueGrid({ { { 0.3, 0.3, 0.3 } }, { { 5.7, 5.7, 5.7 } } }, 0.1);
  std::vector<int> counts(points.size() + 1, 0);
  for (const std::int32_t label : EstimateTissue(points, grid).labels)
  {
    ++counts[label];
  }
  EXPECT_EQ(counts[0], 0);
  // Cells by the number of sides that cut them: where eight meet at a point, single walls are at the mercy of the grid.
  std::array<double, 4> sums{};
  std::array<int, 4>    cells{};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto sides = std::count_if(
      points[i].begin(), points[i].end(), [outer](double value) { return value == outer || value == 6.0 - outer; });
    sums[static_cast<std::size_t>(sides)] += counts[i + 1];
    ++cells[static_cast<std::size_t>(sides)];
  }
  for (std::size_t sides = 0; sides < 4; ++sides)
  {
    EXPECT_NEAR(sums[sides] / cells[sides] / (1000.0 * std::pow(0.7, sides)), 1.0, 0.04) << sides;
  }
}

TEST(PointTissue, TrustsPointsThatCanBeCentroidsAndHoldsBackFromOthers)
{
  std::vector<Point> points = CentroidsOfCells();
  EXPECT_LT(MeanDistance(points), 0.03);
  Random random(1);
  for (Point & p : points)
  {
    for (double & value : p)
    {
      value = std::clamp(value + 0.6 * (random.Uniform() - 0.5), 0.05, 5.95);
    }
  }
  EXPECT_GT(MeanDistance(points), 0.06);
}

TEST(PointTissue, VotesOnTheQuadruplesOfItsCells)
{
  const std::vector<Point> points = CentroidsOfCells();
  const PointTissue        tissue = EstimateTissue(points, MakePointGrid(points, Cube, 500));
  std::size_t              sure = 0;
  for (const JunctionVote & vote : tissue.votes)
  {
    EXPECT_GE(vote.cells[0], ExteriorVertex);
    EXPECT_LE(vote.cells[3], 216);
    EXPECT_GT(vote.share, 0.0);
    EXPECT_LT(vote.share, 1.0 + 1e-9);
    sure += vote.share > 0.9 ? 1 : 0;
  }
  // A complex of as many cells has six or seven tetrahedra a cell.
  EXPECT_GT(tissue.votes.size(), 6u * 216u);
  EXPECT_GT(sure, 216u);
  EXPECT_LT(sure, 6u * 216u);
}

TEST(PointTissue, VotesAreMoreDividedThePoorerThePointsAre)
{
  const auto meanShare = [](double displacement) {
    std::vector<Point> points = CentroidsOfCells();
    Random             random(2);
    for (Point & p : points)
    {
      for (double & value : p)
      {
        value = std::clamp(value + displacement * (random.Uniform() - 0.5), 0.05, 5.95);
      }
    }
    const auto votes = EstimateTissue(points, MakePointGrid(points, Cube, 500)).votes;
    double     sum = 0.0;
    for (const JunctionVote & vote : votes)
    {
      sum += vote.share;
    }
    return sum / static_cast<double>(votes.size());
  };
  EXPECT_GT(meanShare(0.0), 1.1 * meanShare(0.6));
}

TEST(PointTissue, GivesPointsThatAreCloseACellEach)
{
  std::vector<Point> points = Lattice();
  points.push_back({ { 2.5, 2.5, 2.6 } });
  points.push_back({ { 5.9, 5.9, 5.99 } });
  const TissueGrid          grid = MakePointGrid(points, Cube, 300);
  std::vector<std::int64_t> counts(points.size() + 1, 0);
  for (const std::int32_t label : EstimateTissue(points, grid).labels)
  {
    ++counts[label];
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_GT(counts[i + 1], 0) << i;
  }
}

TEST(PointTissue, MakesAGridOfSoManyPointsACell)
{
  const TissueGrid grid = MakePointGrid(Lattice(), Cube, 1000);
  EXPECT_NEAR(static_cast<double>(grid.NumberOfPoints()) / 216, 1000, 500);
  EXPECT_NEAR(
    static_cast<double>(MakePointGrid(Lattice(), Cube, 8000).NumberOfPoints()) / grid.NumberOfPoints(), 8, 0.8);
  EXPECT_THROW(MakePointGrid(Lattice(), Cube, 49), std::invalid_argument);
  EXPECT_THROW(MakePointGrid(Lattice(), Cube, std::nan("")), std::invalid_argument);
  std::vector<Point> points = Lattice();
  points.push_back({ { 1e4, 0.0, 0.0 } });
  try
  {
    MakePointGrid(points, PaddedBox(points), 1000);
    ADD_FAILURE() << "a grid too large";
  }
  catch (const std::invalid_argument & error)
  {
    const std::string what = error.what();
    EXPECT_NE(what.find("voxels at 1000 a cell, must have 5e+08 at most"), std::string::npos) << what;
    EXPECT_NE(what.find("point 216 at (10000, 0, 0) is the farthest from its nearest"), std::string::npos) << what;
  }
  const Box padded = PaddedBox(Lattice());
  EXPECT_LT(padded.lower[0], -0.5);
  EXPECT_GT(padded.upper[2], 6.5);
}

TEST(PointTissue, CanBeAborted)
{
  double     last = 0.0;
  const auto progress = [&last](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return fraction < 0.5;
  };
  const TissueGrid grid = MakePointGrid(Lattice(), Cube, 100);
  EXPECT_THROW(EstimateTissue(Lattice(), grid, TissueLayering::Automatic, Execution({}, progress)), Aborted);
  EXPECT_GE(last, 0.5);
  last = 0.0;
  const auto remember = [&last](double fraction) {
    last = fraction;
    return true;
  };
  EXPECT_NO_THROW(EstimateTissue(Lattice(), grid, TissueLayering::Automatic, Execution({}, remember)));
  EXPECT_EQ(last, 1.0);
}

TEST(PointTissue, OutliersAreThePointsFarFromAllOthers)
{
  std::vector<Point> points;
  for (int i = 0; i < 64; ++i)
  {
    points.push_back({ { 1.0 * (i % 4), 1.1 * (i / 4 % 4), 1.2 * (i / 16) } });
  }
  EXPECT_TRUE(FindOutliers(points).empty());
  EXPECT_TRUE(FindOutliers({}).empty());
  EXPECT_TRUE(FindOutliers({ points[0], points[1] }).empty());
  points.insert(points.begin() + 7, { { 100.0, 0.0, 0.0 } });
  points.push_back({ { 0.0, 200.0, 0.0 } });
  points.push_back({ { 0.0, 201.0, 0.0 } });
  EXPECT_EQ(FindOutliers(points), (std::vector<std::size_t>{ 7, 65, 66 }));
  // A part of the tissue far off is none.
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ { 500.0 + i % 2, 1.0 * (i / 2 % 2), 1.0 * (i / 4) } });
  }
  EXPECT_EQ(FindOutliers(points), (std::vector<std::size_t>{ 7, 65, 66 }));
}
