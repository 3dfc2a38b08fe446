/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "FourCubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace
{
using namespace tissue;

/** The values of a column of a type, which must be there. */
template <typename TNumber>
std::vector<TNumber>
ValuesOf(const std::vector<StatisticColumn> & columns, const std::string & name)
{
  const auto column = std::find_if(
    columns.begin(), columns.end(), [&](const StatisticColumn & candidate) { return candidate.name == name; });
  return std::get<std::vector<TNumber>>(column->values);
}

std::vector<StatisticColumn>
CellColumnsOf(const FourCubes & tissue)
{
  return MakeCellColumns(tissue.mesh, tissue.cells, CheckCellSurfaces(tissue.mesh, 5), tissue.Statistics());
}
} // namespace

TEST(StatisticColumns, OfCellsHaveARowForEachVertex)
{
  const auto columns = CellColumnsOf(FourCubes());
  EXPECT_EQ(columns.front().name, "Label");
  EXPECT_EQ(ValuesOf<std::int64_t>(columns, "Label"), (std::vector<std::int64_t>{ 7, 10, 20, 30, 40 }));
  for (const StatisticColumn & column : columns)
  {
    const std::size_t size = std::visit([](const auto & values) { return values.size(); }, column.values);
    EXPECT_EQ(size, 5u * column.numberOfComponents) << column.name;
  }
  const auto volumes = ValuesOf<double>(columns, "Volume");
  const auto neighbors = ValuesOf<std::int32_t>(columns, "NumberOfNeighbors");
  const auto closed = ValuesOf<std::uint8_t>(columns, "IsClosed");
  for (std::size_t v = 1; v < 5; ++v)
  {
    EXPECT_DOUBLE_EQ(volumes[v], 1.0);
    EXPECT_EQ(neighbors[v], 2);
    EXPECT_EQ(closed[v], 1);
  }
  EXPECT_EQ(ValuesOf<std::int64_t>(columns, "NumberOfStrayVoxels")[4], 5);
  EXPECT_EQ(ValuesOf<double>(columns, "MajorAxis").size(), 15u);
}

TEST(StatisticColumns, OfWallsHaveTheirLabelsAndMeasures)
{
  const FourCubes tissue;
  const auto      columns = MakeWallColumns(tissue.mesh, tissue.cells, tissue.Statistics());
  const auto      first = ValuesOf<std::int64_t>(columns, "Label0");
  const auto      second = ValuesOf<std::int64_t>(columns, "Label1");
  const auto      areas = ValuesOf<double>(columns, "Area");
  ASSERT_EQ(areas.size(), 8u);
  EXPECT_EQ(std::count(second.begin(), second.end(), 7), 4);
  for (std::size_t w = 0; w < areas.size(); ++w)
  {
    EXPECT_DOUBLE_EQ(areas[w], second[w] == 7 ? 4.0 : 1.0);
    EXPECT_TRUE(second[w] == 7 || first[w] < second[w]);
  }
  EXPECT_EQ(ValuesOf<double>(columns, "Normal").size(), 24u);
  EXPECT_EQ(ValuesOf<std::int32_t>(columns, "WallId").back(), 7);
}

TEST(StatisticColumns, PairsOfNeighborsAreWithoutTheExterior)
{
  const FourCubes tissue;
  const auto      pairs = FindNeighborPairs(tissue.mesh, tissue.Statistics().walls);
  ASSERT_EQ(pairs.size(), 4u);
  for (const auto & [cells, pair] : pairs)
  {
    EXPECT_TRUE(0 < cells[0] && cells[0] < cells[1]);
    EXPECT_DOUBLE_EQ(pair.area, 1.0);
    EXPECT_EQ(pair.numberOfWalls, 1);
  }
}

TEST(StatisticColumns, RefuseStatisticsOfAnotherMesh)
{
  const FourCubes  tissue;
  TissueStatistics statistics = tissue.Statistics();
  statistics.walls.pop_back();
  EXPECT_THROW(MakeWallColumns(tissue.mesh, tissue.cells, statistics), std::invalid_argument);
  EXPECT_THROW(MakeCellColumns(tissue.mesh, tissue.cells, CheckCellSurfaces(tissue.mesh, 5), statistics),
               std::invalid_argument);
  EXPECT_THROW(MakeCellColumns(tissue.mesh, tissue.cells, CellSurfaceCheck(), tissue.Statistics()),
               std::invalid_argument);
}
