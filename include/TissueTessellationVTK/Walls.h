/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKWalls_h
#define TissueTessellationVTKWalls_h

#include "TissueTessellationVTK/Arrays.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkDataSetAttributes.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>

namespace tissue
{
namespace bridge
{
inline vtkSmartPointer<vtkPoints>
MakeMeshPoints(const WallMesh & mesh)
{
  vtkSmartPointer<vtkPoints> points = MakePoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    points->SetPoint(static_cast<vtkIdType>(p), mesh.points[p].data());
  }
  return points;
}

/** Adds the labels of the two cells of each of the given walls. */
inline void
AddSideLabels(vtkFieldData * attributes, const WallMesh & mesh, const std::vector<Cell> & cells,
              const std::vector<WallId> & walls)
{
  for (int side = 0; side < 2; ++side)
  {
    AddColumn<LabelArray>(attributes, side == 0 ? "Label0" : "Label1", walls, [&](WallId w) {
      return cells[mesh.walls[w].cells[side]].label;
    });
  }
}

/** The triangles of MakeWallPolyData, without what is measured of the walls. */
inline vtkSmartPointer<vtkPolyData>
MakeTriangles(const WallMesh & mesh, const std::vector<Cell> & cells)
{
  RequireConsistentIndices(mesh, static_cast<VertexId>(cells.size()));
  // One pass over the triangles fills the polygons and all arrays of cells; then points and their array are added.
  const vtkIdType numberOfTriangles = static_cast<vtkIdType>(mesh.triangles.size());

  vtkNew<vtkCellArray> polygons;
  polygons->AllocateExact(numberOfTriangles, 3 * numberOfTriangles);
  const auto label = MakeArray<LabelArray>("Label", 1, numberOfTriangles);
  const auto boundaryLabels = MakeArray<LabelArray>("BoundaryLabels", 2, numberOfTriangles);
  const auto wallId = MakeArray<vtkTypeInt32Array>("WallId", 1, numberOfTriangles);
  for (vtkIdType t = 0; t < numberOfTriangles; ++t)
  {
    const Triangle &   triangle = mesh.triangles[t];
    const WallId       wall = mesh.wallOfTriangle[t];
    const VertexPair & sides = mesh.walls[wall].cells;
    polygons->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
    label->SetValue(t, cells[sides[0]].label);
    boundaryLabels->SetTypedComponent(t, 0, cells[sides[0]].label);
    boundaryLabels->SetTypedComponent(t, 1, cells[sides[1]].label);
    wallId->SetValue(t, wall);
  }

  vtkSmartPointer<vtkPolyData> walls = vtkSmartPointer<vtkPolyData>::New();
  walls->SetPoints(MakeMeshPoints(mesh));
  walls->SetPolys(polygons);
  walls->GetCellData()->SetScalars(label);
  walls->GetCellData()->AddArray(boundaryLabels);
  AddSideLabels(walls->GetCellData(), mesh, cells, mesh.wallOfTriangle);
  walls->GetCellData()->AddArray(wallId);
  if (!mesh.numberOfCells.empty())
  {
    const auto numberOfCells = MakeArray<vtkTypeUInt8Array>("NumberOfCells", 1, walls->GetNumberOfPoints());
    std::copy(mesh.numberOfCells.begin(), mesh.numberOfCells.end(), numberOfCells->GetPointer(0));
    walls->GetPointData()->AddArray(numberOfCells);
  }
  AddCoordinateSystem(walls);
  return walls;
}

/** Adds what is measured of the walls to their triangles. */
inline void
AddWallShapes(vtkFieldData * attributes, const WallMesh & mesh, const std::vector<WallStatistics> & walls)
{
  const auto add = [&](const char * name, double WallStatistics::*member) {
    AddColumn<vtkTypeFloat64Array>(attributes, name, mesh.wallOfTriangle, [&](WallId w) { return walls[w].*member; });
  };
  add("WallArea", &WallStatistics::area);
  add("WallPlanarity", &WallStatistics::planarity);
  add("WallPlaneDistance", &WallStatistics::planeDistance);
  add("WallMeanCurvature", &WallStatistics::meanCurvature);
}
} // namespace bridge

/** \brief Makes VTK's triangles of the walls of a tissue, each wall once.
 *
 * Points and triangles keep the order, the indices and the winding of the mesh: a normal points from the first cell of
 * its wall to the second, the cell of the smaller label is the first, the exterior always the second (the convention of
 * vtkSurfaceNets3D). Coordinates are in double precision, in the units and axes of the image.
 *
 * | array | of | type, components | meaning |
 * |---|---|---|---|
 * | `Label` (active scalars) | cells | Int64, 1 | label of the first cell |
 * | `BoundaryLabels` | cells | Int64, 2 | labels of the first and the second cell |
 * | `Label0`, `Label1` | cells | Int64, 1 | the same, for programs that choose by one component |
 * | `WallId` | cells | Int32, 1 | index of the wall in the mesh; the triangles of a wall are consecutive |
 * | `WallArea` | cells | Float64, 1 | area of the whole wall, in squared units |
 * | `WallPlanarity`, `WallPlaneDistance`, `WallMeanCurvature` | cells | Float64, 1 | of the wall, as in WallStatistics
 * | | `NumberOfCells` | points | UInt8, 1 | cells that meet at the point: 2 wall, 3 edge, 4 corner | | `SPACE` | field
 * | String, 1 | `LPS` |
 *
 * `cells` gives the labels, by the vertices of the mesh. `NumberOfCells` is left out where the mesh has none.
 * \throws std::invalid_argument as RequireConsistentIndices does. */
inline vtkSmartPointer<vtkPolyData>
MakeWallPolyData(const WallMesh & mesh, const std::vector<Cell> & cells)
{
  const auto triangles = bridge::MakeTriangles(mesh, cells);
  bridge::AddWallShapes(triangles->GetCellData(), mesh, MeasureWalls(mesh));
  return triangles;
}

/** \brief The same with what is measured already, and with `WallCutArea` (WallStatistics::cutArea), Float64, of the
 * whole wall.
 *
 * \throws std::invalid_argument where `statistics`, the result of MeasureTissue, is for other numbers, too. */
inline vtkSmartPointer<vtkPolyData>
MakeWallPolyData(const WallMesh & mesh, const std::vector<Cell> & cells, const TissueStatistics & statistics)
{
  const auto triangles = bridge::MakeTriangles(mesh, cells);
  RequireStatisticsOf(mesh, cells, statistics);
  bridge::AddWallShapes(triangles->GetCellData(), mesh, statistics.walls);
  bridge::AddColumn<vtkTypeFloat64Array>(triangles->GetCellData(), "WallCutArea", mesh.wallOfTriangle, [&](WallId w) {
    return statistics.walls[w].cutArea;
  });
  return triangles;
}

/** \brief Makes a table with one row of statistics for each wall, in the order of the mesh.
 *
 * | column | type | meaning |
 * |---|---|---|
 * | `WallId` | Int32 | index of the wall in the mesh |
 * | `Label0`, `Label1` | Int64 | labels of the first and the second cell |
 * | `Area` | Float64 | its area |
 * | `Center`, `Normal` | Float64, 3 components | its barycentre, and the mean direction from the first cell to the
 * second | | `Planarity`, `PlaneDistance`, `MeanCurvature`, `CutArea` | Float64 | as in WallStatistics |
 *
 * Lengths are in the units of the image. What cannot be measured is not a number. `statistics` is the result of
 * MeasureTissue.
 * \throws std::invalid_argument where it is for other numbers, or as RequireConsistentIndices does. */
inline vtkSmartPointer<vtkTable>
MakeWallTable(const WallMesh & mesh, const std::vector<Cell> & cells, const TissueStatistics & statistics)
{
  const std::vector<WallId> walls = bridge::NumbersOf(0, mesh.walls.size());
  const auto                table = vtkSmartPointer<vtkTable>::New();
  for (const StatisticColumn & column : MakeWallColumns(mesh, cells, statistics))
  {
    bridge::AddColumn(table->GetRowData(), column, walls);
  }
  return table;
}
} // namespace tissue

#endif
