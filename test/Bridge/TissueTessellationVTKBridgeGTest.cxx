/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "FourCubes.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationVTKBridge.h"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkIdList.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

// All figures are derived by hand, see FourCubes.

namespace
{
using tissue::Point;

double
GetValue(vtkDataSetAttributes * attributes, const char * name, vtkIdType row, int component = 0)
{
  vtkDataArray * array = attributes->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array ? array->GetComponent(row, component) : -1e9;
}

std::string
GetSpace(vtkDataObject * data)
{
  auto * array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("SPACE"));
  return array && array->GetNumberOfValues() == 1 ? std::string(array->GetValue(0)) : "";
}

/** Six times the volume of the tetrahedron of a triangle and a point. */
double
SpatProduct(const double * a, const double * b, const double * c, const double * from)
{
  double u[3];
  double v[3];
  double w[3];
  double normal[3];
  vtkMath::Subtract(a, from, u);
  vtkMath::Subtract(b, from, v);
  vtkMath::Subtract(c, from, w);
  vtkMath::Cross(v, w, normal);
  return vtkMath::Dot(u, normal);
}

double
SpatProduct(vtkPointSet * data, vtkIdList * triangle, const double * from)
{
  Point corners[3];
  for (int i = 0; i < 3; ++i)
  {
    data->GetPoint(triangle->GetId(i), corners[i].data());
  }
  return SpatProduct(corners[0].data(), corners[1].data(), corners[2].data(), from);
}
} // namespace

TEST(TissueTessellationVTKBridge, WallsHaveTheirArrays)
{
  const FourCubes tissue;
  const auto      walls = tissue::MakeWallPolyData(tissue.mesh, tissue.cells);
  ASSERT_EQ(walls->GetNumberOfPoints(), 18);
  ASSERT_EQ(walls->GetNumberOfPolys(), 40);
  EXPECT_EQ(GetSpace(walls), "LPS");
  vtkCellData * data = walls->GetCellData();
  ASSERT_NE(data->GetScalars(), nullptr);
  EXPECT_STREQ(data->GetScalars()->GetName(), "Label");
  EXPECT_EQ(data->GetScalars()->GetNumberOfComponents(), 1);
  ASSERT_NE(data->GetArray("BoundaryLabels"), nullptr);
  EXPECT_EQ(data->GetArray("BoundaryLabels")->GetNumberOfComponents(), 2);
  EXPECT_NE(data->GetArray("WallPlanarity"), nullptr);
  EXPECT_EQ(data->GetArray("WallCutArea"), nullptr); // what is cut is not known of walls alone

  std::map<int, int> trianglesOfWall;
  for (vtkIdType t = 0; t < 40; ++t)
  {
    const double first = GetValue(data, "BoundaryLabels", t, 0);
    const double second = GetValue(data, "BoundaryLabels", t, 1);
    EXPECT_EQ(GetValue(data, "Label", t), first);
    EXPECT_EQ(GetValue(data, "Label0", t), first);
    EXPECT_EQ(GetValue(data, "Label1", t), second);
    EXPECT_NE(first, 7.0);
    EXPECT_TRUE(second == 7.0 || first < second);
    EXPECT_DOUBLE_EQ(GetValue(data, "WallArea", t), second == 7.0 ? 4.0 : 1.0);
    ++trianglesOfWall[static_cast<int>(GetValue(data, "WallId", t))];
  }
  std::map<int, int> wallsOfSize;
  for (const auto & wall : trianglesOfWall)
  {
    ++wallsOfSize[wall.second];
  }
  EXPECT_EQ(wallsOfSize, (std::map<int, int>{ { 2, 4 }, { 8, 4 } }));

  std::map<int, int> pointsOfNumber;
  for (vtkIdType p = 0; p < 18; ++p)
  {
    ++pointsOfNumber[static_cast<int>(GetValue(walls->GetPointData(), "NumberOfCells", p))];
  }
  EXPECT_EQ(pointsOfNumber, (std::map<int, int>{ { 2, 8 }, { 3, 8 }, { 5, 2 } }));
}

TEST(TissueTessellationVTKBridge, NormalsPointFromTheFirstLabelToTheSecond)
{
  const FourCubes tissue;
  const auto      walls = tissue::MakeWallPolyData(tissue.mesh, tissue.cells);
  for (vtkIdType t = 0; t < walls->GetNumberOfCells(); ++t)
  {
    const auto    vertexOf = [](double label) { return static_cast<int>(label / 10.0); };
    const double  second = GetValue(walls->GetCellData(), "BoundaryLabels", t, 1);
    vtkIdList *   ids = walls->GetCell(t)->GetPointIds();
    const Point & inside = tissue.cells[vertexOf(GetValue(walls->GetCellData(), "Label", t))].center;
    EXPECT_GT(SpatProduct(walls, ids, inside.data()), 0.0);
    if (second != 7.0)
    {
      EXPECT_LT(SpatProduct(walls, ids, tissue.cells[vertexOf(second)].center.data()), 0.0);
    }
  }
}

TEST(TissueTessellationVTKBridge, LabelsKeepTheirSixtyFourBits)
{
  FourCubes tissue;
  tissue.cells[4].label = (std::int64_t(1) << 53) + 1; // has no double
  const auto walls = tissue::MakeWallPolyData(tissue.mesh, tissue.cells);
  auto *     labels = vtkTypeInt64Array::SafeDownCast(walls->GetCellData()->GetScalars());
  ASSERT_NE(labels, nullptr);
  EXPECT_EQ(labels->GetValue(39), tissue.cells[4].label);
}

TEST(TissueTessellationVTKBridge, EachCellIsAClosedPolyhedronWithItsStatistics)
{
  const FourCubes tissue;
  const auto      check = tissue::CheckCellSurfaces(tissue.mesh, 5);
  const auto      grid = tissue::MakeCellGrid(tissue.mesh, tissue.cells, check, tissue.Statistics());
  ASSERT_EQ(grid->GetNumberOfCells(), 4);
  EXPECT_EQ(GetSpace(grid), "") << "Programs that read no text arrays are to read it.";
  vtkCellData * data = grid->GetCellData();
  EXPECT_STREQ(data->GetScalars()->GetName(), "Label");
  for (vtkIdType c = 0; c < 4; ++c)
  {
    vtkCell * polyhedron = grid->GetCell(c);
    ASSERT_EQ(polyhedron->GetCellType(), VTK_POLYHEDRON);
    EXPECT_EQ(polyhedron->GetNumberOfPoints(), 8);
    ASSERT_EQ(polyhedron->GetNumberOfFaces(), 12);
    double volume = 0.0;
    for (int f = 0; f < 12; ++f)
    {
      const double origin[3] = { 0.0, 0.0, 0.0 };
      volume += SpatProduct(grid, polyhedron->GetFace(f)->GetPointIds(), origin) / 6.0;
    }
    EXPECT_DOUBLE_EQ(volume, 1.0);
    EXPECT_EQ(GetValue(data, "Label", c), 10.0 * (c + 1));
    EXPECT_EQ(GetValue(data, "CenterX", c), tissue.cells[c + 1].center[0]);
    EXPECT_EQ(GetValue(data, "CenterY", c), tissue.cells[c + 1].center[1]);
    EXPECT_EQ(GetValue(data, "CenterZ", c), 0.5);
    EXPECT_DOUBLE_EQ(GetValue(data, "Volume", c), 1.0);
    EXPECT_EQ(GetValue(data, "ImageVolume", c), 0.875);
    EXPECT_DOUBLE_EQ(GetValue(data, "SurfaceArea", c), 6.0);
    EXPECT_EQ(GetValue(data, "NumberOfNeighbors", c), 2.0); // those across the edge share no wall
    EXPECT_EQ(GetValue(data, "NumberOfTriangles", c), 12.0);
    EXPECT_EQ(GetValue(data, "EulerCharacteristic", c), 2.0);
    EXPECT_EQ(GetValue(data, "IsClosed", c), 1.0);
    EXPECT_EQ(GetValue(data, "TouchesExterior", c), 1.0);
    EXPECT_EQ(GetValue(data, "TouchesBorder", c), c == 2 ? 1.0 : 0.0);
    EXPECT_EQ(GetValue(data, "NumberOfPieces", c), c == 3 ? 3.0 : 1.0);
    EXPECT_EQ(GetValue(data, "NumberOfVoxels", c), 1001.0 + c);
    EXPECT_EQ(GetValue(data, "NumberOfStrayVoxels", c), c == 3 ? 5.0 : 0.0);
    EXPECT_DOUBLE_EQ(GetValue(data, "ExteriorArea", c), 4.0);
    EXPECT_EQ(GetValue(data, "CutArea", c), 0.0);
    EXPECT_EQ(GetValue(data, "Layer", c), 1.0);
    EXPECT_NEAR(GetValue(data, "Sphericity", c), 0.805996, 1e-6); // of a cube
    EXPECT_NEAR(GetValue(data, "Elongation", c), 1.0, 1e-9);
    EXPECT_NEAR(GetValue(data, "Flatness", c), 1.0, 1e-9);
    for (const std::string axis : { "MajorAxis", "MiddleAxis", "MinorAxis" })
    {
      EXPECT_NEAR(GetValue(data, (axis + "Length").c_str(), c), std::sqrt(5.0 / 3.0), 1e-9);
      ASSERT_EQ(data->GetArray(axis.c_str())->GetNumberOfComponents(), 3);
      EXPECT_STREQ(data->GetArray(axis.c_str())->GetComponentName(2), "Z");
    }
  }
}

TEST(TissueTessellationVTKBridge, TheSurfacesOfCellsAreApartAndCanBeMovedApart)
{
  using tissue::  operator+;
  using tissue::  operator-;
  using tissue::  operator*;
  const FourCubes tissue;
  const auto      check = tissue::CheckCellSurfaces(tissue.mesh, 5);
  const auto      surfaces = tissue::MakeCellSurfaces(tissue.mesh, tissue.cells, check, tissue.Statistics());
  ASSERT_EQ(surfaces->GetNumberOfCells(), 48);
  ASSERT_EQ(surfaces->GetNumberOfPoints(), 32);
  EXPECT_EQ(GetSpace(surfaces), "LPS");
  double volumes[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (vtkIdType t = 0; t < 48; ++t)
  {
    const double origin[3] = { 0.0, 0.0, 0.0 };
    volumes[t / 12] += SpatProduct(surfaces, surfaces->GetCell(t)->GetPointIds(), origin) / 6.0;
    EXPECT_EQ(GetValue(surfaces->GetCellData(), "Label", t), 10.0 * static_cast<double>(t / 12 + 1));
    EXPECT_DOUBLE_EQ(GetValue(surfaces->GetCellData(), "SurfaceArea", t), 6.0);
  }
  Point middle{ { 0.0, 0.0, 0.0 } };
  for (int c = 1; c < 5; ++c)
  {
    EXPECT_DOUBLE_EQ(volumes[c - 1], 1.0);
    middle = middle + 0.25 * tissue.cells[c].center;
  }
  for (vtkIdType p = 0; p < 32; ++p)
  {
    const Point way = tissue.cells[p / 8 + 1].center - middle;
    double      squares = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_DOUBLE_EQ(GetValue(surfaces->GetPointData(), "FromCenter", p, axis), way[axis]);
      squares += std::pow(GetValue(surfaces->GetPointData(), "Normals", p, axis), 2);
    }
    EXPECT_NEAR(squares, 1.0, 1e-12);
  }
}

TEST(TissueTessellationVTKBridge, ACellWithoutTrianglesHasARowButNoPolyhedron)
{
  FourCubes tissue;
  tissue.cells.insert(tissue.cells.end(), tissue::Cell());
  tissue.cells[5].label = 50;
  const auto check = tissue::CheckCellSurfaces(tissue.mesh, 6);
  EXPECT_EQ(tissue::MakeCellGrid(tissue.mesh, tissue.cells, check, tissue.Statistics())->GetNumberOfCells(), 4);
  const auto table = tissue::MakeCellTable(tissue.mesh, tissue.cells, check, tissue.Statistics());
  ASSERT_EQ(table->GetNumberOfRows(), 5);
  EXPECT_EQ(GetValue(table->GetRowData(), "Label", 4), 50.0);
  EXPECT_EQ(GetValue(table->GetRowData(), "NumberOfTriangles", 4), 0.0);
  EXPECT_EQ(GetValue(table->GetRowData(), "IsClosed", 4), 0.0);
}

TEST(TissueTessellationVTKBridge, CurvaturesOfCellsThatHaveNoneAreNoNumbers)
{
  const FourCubes tissue;
  auto            statistics = tissue.Statistics();
  statistics.cells[2].curvatures = { 3.0, 1.0 };
  statistics.cells[3].curvatures = tissue::Curvatures();
  const auto table =
    tissue::MakeCellTable(tissue.mesh, tissue.cells, tissue::CheckCellSurfaces(tissue.mesh, 5), statistics);
  const std::map<std::string, double> expected{
    { "MeanCurvature", 2.0 }, { "GaussianCurvature", 3.0 }, { "MaximumCurvature", 3.0 }, { "MinimumCurvature", 1.0 }
  };
  for (const auto & column : expected)
  {
    EXPECT_EQ(GetValue(table->GetRowData(), column.first.c_str(), 1), column.second);
    EXPECT_TRUE(std::isnan(GetValue(table->GetRowData(), column.first.c_str(), 2))) << column.first;
  }
}

TEST(TissueTessellationVTKBridge, EachWallHasARowAndItsStatisticsOnItsTriangles)
{
  const FourCubes tissue;
  const auto      statistics = tissue.Statistics();
  const auto      table = tissue::MakeWallTable(tissue.mesh, tissue.cells, statistics);
  const auto      walls = tissue::MakeWallPolyData(tissue.mesh, tissue.cells, statistics);
  ASSERT_EQ(table->GetNumberOfRows(), 8);
  for (vtkIdType row = 0; row < 8; ++row)
  {
    vtkDataSetAttributes * rows = table->GetRowData();
    const auto &           expected = statistics.walls[row];
    EXPECT_EQ(GetValue(rows, "WallId", row), static_cast<double>(row));
    EXPECT_EQ(GetValue(rows, "Label0", row), tissue.cells[tissue.mesh.walls[row].cells[0]].label);
    EXPECT_EQ(GetValue(rows, "Label1", row), tissue.cells[tissue.mesh.walls[row].cells[1]].label);
    EXPECT_EQ(GetValue(rows, "Area", row), expected.area);
    EXPECT_EQ(GetValue(rows, "Center", row, 1), expected.center[1]);
    EXPECT_EQ(GetValue(rows, "Normal", row, 2), expected.normal[2]);
    EXPECT_EQ(GetValue(rows, "Planarity", row), expected.planarity);
    EXPECT_EQ(GetValue(rows, "PlaneDistance", row), expected.planeDistance);
    EXPECT_EQ(std::isnan(GetValue(rows, "MeanCurvature", row)), std::isnan(expected.meanCurvature));
    EXPECT_EQ(GetValue(rows, "CutArea", row), 0.0);
  }
  for (vtkIdType t = 0; t < walls->GetNumberOfCells(); ++t)
  {
    const auto & expected = statistics.walls[static_cast<std::size_t>(GetValue(walls->GetCellData(), "WallId", t))];
    EXPECT_EQ(GetValue(walls->GetCellData(), "WallPlanarity", t), expected.planarity);
    EXPECT_EQ(GetValue(walls->GetCellData(), "WallPlaneDistance", t), expected.planeDistance);
    EXPECT_EQ(GetValue(walls->GetCellData(), "WallCutArea", t), 0.0);
    ASSERT_NE(walls->GetCellData()->GetArray("WallMeanCurvature"), nullptr);
  }
}

TEST(TissueTessellationVTKBridge, TheNeighborsAreThePairsOfCellsThatShareWalls)
{
  FourCubes tissue;
  // A second wall of the cells 3 and 4, half of the first.
  const auto first = std::find_if(tissue.mesh.walls.begin(), tissue.mesh.walls.end(), [](const auto & wall) {
    return wall.cells == tissue::VertexPair{ { 3, 4 } };
  });
  const auto number = static_cast<tissue::WallId>(first - tissue.mesh.walls.begin());
  tissue.mesh.walls.push_back(tissue::WallMesh::Wall{ { { 3, 4 } } });
  *std::find(tissue.mesh.wallOfTriangle.begin(), tissue.mesh.wallOfTriangle.end(), number) = 8;
  const auto table = tissue::MakeNeighborTable(tissue.mesh, tissue.cells, tissue.Statistics());
  ASSERT_EQ(table->GetNumberOfRows(), 4);
  std::map<std::array<int, 2>, int> walls;
  for (vtkIdType row = 0; row < 4; ++row)
  {
    vtkDataSetAttributes * rows = table->GetRowData();
    EXPECT_DOUBLE_EQ(GetValue(rows, "weight", row), 1.0);
    walls[{ { static_cast<int>(GetValue(rows, "Label0", row)), static_cast<int>(GetValue(rows, "Label1", row)) } }] =
      static_cast<int>(GetValue(rows, "NumberOfWalls", row));
  }
  EXPECT_EQ(walls,
            (std::map<std::array<int, 2>, int>{
              { { { 10, 20 } }, 1 }, { { { 10, 30 } }, 1 }, { { { 20, 40 } }, 1 }, { { { 30, 40 } }, 2 } }));
}

TEST(TissueTessellationVTKBridge, TetrahedraWithTheExteriorAreTrianglesOfTheSurface)
{
  FourCubes tissue;
  tissue.cells[4].center[2] = 1.5; // off the plane of the three others
  const std::vector<tissue::VertexQuadruple> complex{
    { { 1, 2, 3, 4 } }, { { 0, 1, 2, 3 } }, { { 0, 1, 2, 4 } }, { { 0, 1, 3, 4 } }, { { 0, 2, 3, 4 } }
  };
  for (const double mirrored : { 1.5, -0.5 })
  {
    tissue.cells[4].center[2] = mirrored;
    const auto grid = tissue::MakeComplexGrid(complex, tissue.cells);
    ASSERT_EQ(grid->GetNumberOfPoints(), 4);
    ASSERT_EQ(grid->GetNumberOfCells(), 5);
    EXPECT_EQ(GetSpace(grid), "");
    EXPECT_EQ(GetValue(grid->GetPointData(), "Label", 2), 30.0);
    ASSERT_EQ(grid->GetCellType(0), VTK_TETRA);
    Point corners[4];
    for (int i = 0; i < 4; ++i)
    {
      grid->GetPoint(grid->GetCell(0)->GetPointId(i), corners[i].data());
      EXPECT_EQ(GetValue(grid->GetCellData(), "Labels", 0, i), 10.0 * (i + 1));
    }
    EXPECT_GT(SpatProduct(corners[1].data(), corners[2].data(), corners[3].data(), corners[0].data()), 0.0);
    for (vtkIdType c = 1; c < 5; ++c)
    {
      EXPECT_EQ(grid->GetCellType(c), VTK_TRIANGLE);
      EXPECT_EQ(GetValue(grid->GetCellData(), "Labels", c, 0), 7.0);
    }
    EXPECT_EQ(GetValue(grid->GetCellData(), "Labels", 2, 3), 40.0);
    EXPECT_EQ(grid->GetCell(2)->GetPointId(2), 3);
  }
}

TEST(TissueTessellationVTKBridge, WhatDoesNotFitTogetherIsRefused)
{
  FourCubes  tissue;
  const auto check = tissue::CheckCellSurfaces(tissue.mesh, 5);
  const auto statistics = tissue.Statistics();
  EXPECT_THROW(tissue::MakeComplexGrid({ { { 1, 2, 3, 5 } } }, tissue.cells), std::invalid_argument);
  EXPECT_THROW(tissue::MakeComplexGrid({ { { -1, 2, 3, 4 } } }, tissue.cells), std::invalid_argument);
  const auto refuse = [&](const auto & make) { EXPECT_THROW(make(), std::invalid_argument); };
  const auto refuseAll = [&] {
    refuse([&] { tissue::MakeCellTable(tissue.mesh, tissue.cells, check, statistics); });
    refuse([&] { tissue::MakeCellGrid(tissue.mesh, tissue.cells, check, statistics); });
    refuse([&] { tissue::MakeWallTable(tissue.mesh, tissue.cells, statistics); });
    refuse([&] { tissue::MakeWallPolyData(tissue.mesh, tissue.cells, statistics); });
  };
  tissue.cells.push_back(tissue::Cell());
  refuseAll();
  tissue.cells.resize(4);
  refuseAll();
  refuse([&] { tissue::MakeWallPolyData(tissue.mesh, tissue.cells); });
  refuse([&] { tissue::MakeNeighborTable(tissue.mesh, tissue.cells, statistics); });
}
