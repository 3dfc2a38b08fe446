/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/TissueLayer.h"
#include "TestComplexes.h"
#include "TissueTessellationCore/Points/PointTissue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace tissue_test;

namespace
{
/** Rows of cells one apart, each moved by up to a tenth, in sheets above each other. */
std::vector<Point>
Sheets(int numberOfSheets, double gap)
{
  Random             random(5);
  std::vector<Point> points;
  for (int i = 0; i < 100 * numberOfSheets; ++i)
  {
    Point p{ { i % 10 + 0.5 * (i / 10 % 2), 0.866 * (i / 10 % 10), gap * (i / 100) } };
    for (double & value : p)
    {
      value += 0.2 * (random.Uniform() - 0.5);
    }
    points.push_back(p);
  }
  return points;
}

/** Points spread evenly over a sphere of radius 1 about the origin (a spiral). */
std::vector<Point>
Shell(int numberOfCells)
{
  const double       goldenAngle = 2.39996322972865332;
  std::vector<Point> points;
  for (int i = 0; i < numberOfCells; ++i)
  {
    const double z = 1.0 - 2.0 * (i + 0.5) / numberOfCells;
    const double radius = std::sqrt(1.0 - z * z);
    points.push_back({ { radius * std::cos(goldenAngle * i), radius * std::sin(goldenAngle * i), z } });
  }
  return points;
}

/** The cells of a label image, and the pairs of them that share a face. */
struct LayerCells
{
  std::set<std::pair<std::int32_t, std::int32_t>> pairs;
  std::set<std::int32_t>                          cells;
};

LayerCells
FindCells(const PointTissue & tissue, const TissueGrid & grid)
{
  LayerCells found;
  for (std::int32_t z = 0; z + 1 < grid.size[2]; ++z)
  {
    for (std::int32_t y = 0; y + 1 < grid.size[1]; ++y)
    {
      for (std::int32_t x = 0; x + 1 < grid.size[0]; ++x)
      {
        const std::int32_t here = tissue.labels[grid.Offset(x, y, z)];
        found.cells.insert(here);
        for (const std::size_t next : { grid.Offset(x + 1, y, z), grid.Offset(x, y + 1, z), grid.Offset(x, y, z + 1) })
        {
          const std::int32_t there = tissue.labels[next];
          if (here != there && here > 0 && there > 0)
          {
            found.pairs.emplace(std::min(here, there), std::max(here, there));
          }
        }
      }
    }
  }
  found.cells.erase(0);
  return found;
}
} // namespace

TEST(TissueLayer, IsEvidentOfSheetsAndShellsAlone)
{
  EXPECT_TRUE(TissueLayer(Sheets(1, 1.0)).IsEvident());
  EXPECT_FALSE(TissueLayer(Sheets(2, 1.0)).IsEvident());
  EXPECT_FALSE(TissueLayer(Sheets(3, 1.0)).IsEvident());
  EXPECT_FALSE(TissueLayer(Sheets(3, 3.0)).IsEvident()) << "columns, one above the other";
  EXPECT_TRUE(TissueLayer(Sheets(2, 3.0)).IsEvident()) << "two layers";
  for (const int n : { 30, 150, 1000 })
  {
    EXPECT_TRUE(TissueLayer(Shell(n)).IsEvident()) << n;
  }
  std::vector<Point> curved = Sheets(1, 1.0);
  for (Point & p : curved)
  {
    p = { { 4.0 * std::sin(p[0] / 4.0), p[1], 4.0 * std::cos(p[0] / 4.0) + p[2] } };
  }
  EXPECT_TRUE(TissueLayer(curved).IsEvident());
  EXPECT_FALSE(TissueLayer({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } }).IsEvident());
  EXPECT_TRUE(TissueLayer({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 1, 0 } } }).IsEvident());
}

TEST(TissueLayer, EndsHalfACellAboveBelowAndBesidePoints)
{
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i)
  {
    points.push_back({ { i % 10 * 1.0, i / 10 * 1.0, 0.0 } });
  }
  const TissueGrid grid = MakePointGrid(points, { { { -2, -2, -2 } }, { { 11, 11, 2 } } }, 2000);
  const TissueMask mask = TissueLayer(points).MakeMask(grid);
  const auto isInside = [&](double x, double y, double z) { return mask.inside[grid.OffsetAt({ { x, y, z } })] == 1; };
  EXPECT_TRUE(isInside(4.5, 4.5, 0.4));
  EXPECT_TRUE(isInside(4.5, 4.5, -0.4));
  EXPECT_FALSE(isInside(4.5, 4.5, 0.6));
  EXPECT_FALSE(isInside(4.5, 4.5, -0.6));
  EXPECT_TRUE(isInside(-0.4, 4.0, 0.0));
  EXPECT_FALSE(isInside(-0.7, 4.0, 0.0));
  EXPECT_TRUE(isInside(9.3, 9.3, 0.0));
  EXPECT_FALSE(isInside(9.8, 9.8, 0.0));
}

TEST(TissueLayer, ShellsEncloseExterior)
{
  for (const std::size_t n : { 30, 50, 150 })
  {
    const std::vector<Point> points = Shell(static_cast<int>(n));
    const TissueGrid         grid = MakePointGrid(points, PaddedBox(points), 3000);
    const PointTissue        tissue = EstimateTissue(points, grid);
    EXPECT_TRUE(tissue.votes.empty());
    EXPECT_EQ(tissue.labels[grid.OffsetAt({ { 0, 0, 0 } })], 0) << n;
    const LayerCells found = FindCells(tissue, grid);
    EXPECT_EQ(found.cells.size(), points.size());
    EXPECT_EQ(found.pairs.size(), 3u * n - 6u) << "by Euler's formula: three cells meet everywhere";
    for (const auto & [a, b] : found.pairs)
    {
      EXPECT_LT(Distance(points[static_cast<std::size_t>(a - 1)], points[static_cast<std::size_t>(b - 1)]),
                2.0 * std::sqrt(4.0 * std::acos(-1.0) / static_cast<double>(n)));
    }
  }
}

TEST(TissueLayer, CellsOfAFlatSheetAreItsVoronoiCellsDrawnOut)
{
  std::vector<Point> points = Sheets(1, 1.0);
  for (Point & p : points)
  {
    p[2] = 0.0;
  }
  const TissueGrid  grid = MakePointGrid(points, PaddedBox(points), 500);
  const PointTissue tissue = EstimateTissue(points, grid);
  for (std::int32_t y = 0; y < grid.size[1]; ++y)
  {
    for (std::int32_t x = 0; x < grid.size[0]; ++x)
    {
      std::set<std::int32_t> labels;
      for (std::int32_t z = 0; z < grid.size[2]; ++z)
      {
        labels.insert(tissue.labels[grid.Offset(x, y, z)]);
      }
      EXPECT_LE(labels.size(), 2u) << "a cell, and the exterior above and below";
    }
  }
  EXPECT_EQ(FindCells(tissue, grid).cells.size(), points.size());
  EXPECT_THROW(EstimateTissue(points, grid, TissueLayering::Solid), std::invalid_argument);
}

TEST(TissueLayer, IsMadeOrNotAsAsked)
{
  const std::vector<Point> points = Shell(60);
  const TissueGrid         grid = MakePointGrid(points, PaddedBox(points), 300);
  const std::size_t        center = grid.OffsetAt({ { 0, 0, 0 } });
  EXPECT_NE(EstimateTissue(points, grid, TissueLayering::Solid).labels[center], 0);
  EXPECT_EQ(EstimateTissue(points, grid, TissueLayering::Layer).labels[center], 0);
}
