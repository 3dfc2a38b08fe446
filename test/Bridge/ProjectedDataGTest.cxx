/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationVTK/ProjectedData.h"

#include "FourCubes.h"
#include "TissueTessellationVTK/Cells.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkPolyData.h>

#include <cmath>

namespace
{
using namespace tissue;

/** The cells of the labels 10, 20, 30 and 40 have the values 1 to 4, each wall ten times its number. */
struct FourValues : FourCubes
{
  ProjectedData    data;
  TissueStatistics statistics = this->Statistics();

  FourValues()
  {
    data.ofCells = { { "x", { UnknownStatistic, 1, 2, 3, 4 }, {} }, { "t", {}, { "", "a", "b", "c", "d" } } };
    data.ofWalls = { { "s", {} } };
    for (std::size_t w = 0; w < mesh.walls.size(); ++w)
    {
      data.ofWalls[0].numbers.push_back(10.0 * static_cast<double>(w));
    }
  }
};
} // namespace

TEST(ProjectedData, CellsHaveTheirValuesByTheirLabels)
{
  const FourValues tissue;
  const auto table = MakeCellTable(tissue.mesh, tissue.cells, CheckCellSurfaces(tissue.mesh, 5), tissue.statistics);
  AddCellColumns(table->GetRowData(), tissue.cells, tissue.data);
  for (int row = 0; row < 4; ++row)
  {
    EXPECT_EQ(row + 1, table->GetValueByName(row, "x").ToDouble());
    EXPECT_EQ(std::string(1, static_cast<char>('a' + row)), table->GetValueByName(row, "t").ToString());
  }
  const auto grid = MakeCellGrid(tissue.mesh, tissue.cells, CheckCellSurfaces(tissue.mesh, 5), tissue.statistics);
  AddCellColumns(grid->GetCellData(), tissue.cells, tissue.data, TextColumns::LeftOut);
  EXPECT_EQ(nullptr, grid->GetCellData()->GetAbstractArray("t"));
  EXPECT_EQ(10.0 * grid->GetCellData()->GetArray("x")->GetTuple1(2),
            grid->GetCellData()->GetArray("Label")->GetTuple1(2));
}

TEST(ProjectedData, WallsHaveTheirOwnValuesAndThoseOfBothSides)
{
  const FourValues tissue;
  const auto       walls = MakeWallPolyData(tissue.mesh, tissue.cells, tissue.statistics);
  AddWallColumns(walls->GetCellData(), tissue.cells, tissue.data);
  vtkCellData * const arrays = walls->GetCellData();
  for (vtkIdType t = 0; t < walls->GetNumberOfCells(); ++t)
  {
    EXPECT_EQ(10.0 * arrays->GetArray("WallId")->GetTuple1(t), arrays->GetArray("s")->GetTuple1(t));
    EXPECT_EQ(arrays->GetArray("Label0")->GetTuple1(t), 10.0 * arrays->GetArray("x0")->GetTuple1(t));
    const double second = arrays->GetArray("Label1")->GetTuple1(t);
    const double value = arrays->GetArray("x1")->GetTuple1(t);
    EXPECT_TRUE(second == 7.0 ? std::isnan(value) : second == 10.0 * value);
    EXPECT_EQ(second == 7.0, arrays->GetAbstractArray("t1")->GetVariantValue(t).ToString().empty());
  }
}

TEST(ProjectedData, NeighborsHaveTheMeanOverTheirWalls)
{
  FourValues tissue;
  const auto neighbors = MakeNeighborTable(tissue.mesh, tissue.cells, tissue.statistics);
  // The first two cells get a second wall, three times as large as the first.
  std::size_t first = 0;
  while (tissue.mesh.walls[first].cells != VertexPair{ { 1, 2 } })
  {
    ++first;
  }
  tissue.mesh.walls.push_back(tissue.mesh.walls[first]);
  tissue.statistics.walls.push_back(tissue.statistics.walls[first]);
  tissue.statistics.walls.back().area *= 3.0;
  tissue.data.ofWalls[0].numbers.push_back(100.0);
  AddNeighborColumns(neighbors->GetRowData(), tissue.mesh, tissue.cells, tissue.statistics.walls, tissue.data);
  ASSERT_EQ(10, neighbors->GetValueByName(0, "Label0").ToInt());
  ASSERT_EQ(20, neighbors->GetValueByName(0, "Label1").ToInt());
  EXPECT_DOUBLE_EQ((10.0 * static_cast<double>(first) + 300.0) / 4.0, neighbors->GetValueByName(0, "s").ToDouble());

  tissue.data.ofWalls[0].numbers.pop_back();
  EXPECT_THROW(
    AddNeighborColumns(neighbors->GetRowData(), tissue.mesh, tissue.cells, tissue.statistics.walls, tissue.data),
    std::out_of_range);
}
