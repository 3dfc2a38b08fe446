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
#include <vtkPolyData.h>
#include <vtkTypeFloat64Array.h>
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
    wallId->SetValue(t, wall);
    wallArea->SetValue(t, areas[wall]);
  }

  vtkSmartPointer<vtkPolyData> walls = vtkSmartPointer<vtkPolyData>::New();
  walls->SetPoints(bridge::MakeMeshPoints(mesh));
  walls->SetPolys(polygons);
  walls->GetCellData()->SetScalars(label);
  walls->GetCellData()->AddArray(boundaryLabels);
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
} // namespace tissue

#endif
