/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKWalls_h
#define TissueTessellationVTKWalls_h

#include "TissueTessellationCore/Mesh/WallMeasures.h"
#include "TissueTessellationVTK/Arrays.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkDataSetAttributes.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeUInt8Array.h>

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
 * | `NumberOfCells` | points | UInt8, 1 | cells that meet at the point: 2 wall, 3 edge, 4 corner |
 * | `SPACE` | field | String, 1 | `LPS` |
 *
 * `cells` gives the labels, by the vertices of the mesh. `NumberOfCells` is left out where the mesh has none.
 * \throws std::invalid_argument as RequireConsistentIndices does. */
inline vtkSmartPointer<vtkPolyData>
MakeWallPolyData(const WallMesh & mesh, const std::vector<Cell> & cells)
{
  RequireConsistentIndices(mesh, static_cast<VertexId>(cells.size()));
  // One pass over the triangles fills the polygons and all arrays of cells; then points and their array are added.
  const vtkIdType           numberOfTriangles = static_cast<vtkIdType>(mesh.triangles.size());
  const std::vector<double> areas = ComputeWallAreas(mesh);

  vtkNew<vtkCellArray> polygons;
  polygons->AllocateExact(numberOfTriangles, 3 * numberOfTriangles);
  const auto label = bridge::MakeArray<bridge::LabelArray>("Label", 1, numberOfTriangles);
  const auto boundaryLabels = bridge::MakeArray<bridge::LabelArray>("BoundaryLabels", 2, numberOfTriangles);
  const auto label1 = bridge::MakeArray<bridge::LabelArray>("Label1", 1, numberOfTriangles);
  const auto wallId = bridge::MakeArray<vtkTypeInt32Array>("WallId", 1, numberOfTriangles);
  const auto wallArea = bridge::MakeArray<vtkTypeFloat64Array>("WallArea", 1, numberOfTriangles);
  for (vtkIdType t = 0; t < numberOfTriangles; ++t)
  {
    const Triangle &   triangle = mesh.triangles[t];
    const WallId       wall = mesh.wallOfTriangle[t];
    const VertexPair & sides = mesh.walls[wall].cells;
    polygons->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
    label->SetValue(t, cells[sides[0]].label);
    boundaryLabels->SetTypedComponent(t, 0, cells[sides[0]].label);
    boundaryLabels->SetTypedComponent(t, 1, cells[sides[1]].label);
    label1->SetValue(t, cells[sides[1]].label);
    wallId->SetValue(t, wall);
    wallArea->SetValue(t, areas[wall]);
  }

  vtkSmartPointer<vtkPolyData> walls = vtkSmartPointer<vtkPolyData>::New();
  walls->SetPoints(bridge::MakeMeshPoints(mesh));
  walls->SetPolys(polygons);
  walls->GetCellData()->SetScalars(label);
  walls->GetCellData()->AddArray(boundaryLabels);
  vtkSmartPointer<bridge::LabelArray> label0 = vtkSmartPointer<bridge::LabelArray>::New();
  label0->DeepCopy(label);
  label0->SetName("Label0");
  walls->GetCellData()->AddArray(label0);
  walls->GetCellData()->AddArray(label1);
  walls->GetCellData()->AddArray(wallId);
  walls->GetCellData()->AddArray(wallArea);
  if (!mesh.numberOfCells.empty())
  {
    const auto numberOfCells = bridge::MakeArray<vtkTypeUInt8Array>("NumberOfCells", 1, walls->GetNumberOfPoints());
    std::copy(mesh.numberOfCells.begin(), mesh.numberOfCells.end(), numberOfCells->GetPointer(0));
    walls->GetPointData()->AddArray(numberOfCells);
  }
  bridge::AddCoordinateSystem(walls);
  return walls;
}

/** \brief The same with the statistics of each wall on its triangles: `WallPlanarity`, `WallPlaneDistance`,
 * `WallMeanCurvature` and `WallCutArea`, Float64, as in WallStatistics.
 *
 * \throws std::invalid_argument where `statistics`, the result of MeasureTissue, is for other numbers, too. */
inline vtkSmartPointer<vtkPolyData>
MakeWallPolyData(const WallMesh & mesh, const std::vector<Cell> & cells, const TissueStatistics & statistics)
{
  bridge::RequireStatisticsOf(mesh, cells, statistics);
  const auto polygons = MakeWallPolyData(mesh, cells);
  const auto add = [&](const char * name, double WallStatistics::*member) {
    bridge::AddColumn<vtkTypeFloat64Array>(
      polygons->GetCellData(), name, mesh.wallOfTriangle, [&](WallId w) { return statistics.walls[w].*member; });
  };
  add("WallPlanarity", &WallStatistics::planarity);
  add("WallPlaneDistance", &WallStatistics::planeDistance);
  add("WallMeanCurvature", &WallStatistics::meanCurvature);
  add("WallCutArea", &WallStatistics::cutArea);
  return polygons;
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
  RequireConsistentIndices(mesh, static_cast<VertexId>(cells.size()));
  bridge::RequireStatisticsOf(mesh, cells, statistics);
  const std::vector<WallId> walls = bridge::NumbersOf(0, mesh.walls.size());
  const auto                table = vtkSmartPointer<vtkTable>::New();
  vtkFieldData * const      rows = table->GetRowData();
  const auto                add = [&](const char * name, double WallStatistics::*member) {
    bridge::AddColumn<vtkTypeFloat64Array>(rows, name, walls, [&](WallId w) { return statistics.walls[w].*member; });
  };
  bridge::AddColumn<vtkTypeInt32Array>(rows, "WallId", walls, [](WallId w) { return w; });
  for (int side = 0; side < 2; ++side)
  {
    bridge::AddColumn<bridge::LabelArray>(
      rows, side == 0 ? "Label0" : "Label1", walls, [&](WallId w) { return cells[mesh.walls[w].cells[side]].label; });
  }
  add("Area", &WallStatistics::area);
  bridge::AddVectorColumn(rows, "Center", walls, [&](WallId w) { return statistics.walls[w].center; });
  bridge::AddVectorColumn(rows, "Normal", walls, [&](WallId w) { return statistics.walls[w].normal; });
  add("Planarity", &WallStatistics::planarity);
  add("PlaneDistance", &WallStatistics::planeDistance);
  add("MeanCurvature", &WallStatistics::meanCurvature);
  add("CutArea", &WallStatistics::cutArea);
  return table;
}
} // namespace tissue

#endif
