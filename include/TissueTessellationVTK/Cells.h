/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKCells_h
#define TissueTessellationVTKCells_h

#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "TissueTessellationVTK/Walls.h"

#include <vtkDataSetAttributes.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <map>

namespace tissue
{
namespace bridge
{
/** Adds the columns of MakeCellTable in its order, with one row for each of the given vertices. */
inline void
AddCellStatistics(vtkDataSetAttributes * attributes, const WallMesh & mesh, const std::vector<Cell> & cells,
                  const CellSurfaceCheck & check, const TissueStatistics & statistics,
                  const std::vector<VertexId> & vertices)
{
  for (const StatisticColumn & column : MakeCellColumns(mesh, cells, check, statistics))
  {
    AddColumn(attributes, column, vertices);
  }
  attributes->SetActiveScalars("Label");
}

/** Each of the triangles' points once, ascending. */
inline std::vector<vtkIdType>
PointsOf(const std::vector<vtkIdType> & triangles)
{
  std::vector<vtkIdType> points = triangles;
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/** Inserts the polyhedron of a cell from its outward triangles, three points each. */
inline void
InsertPolyhedron(vtkUnstructuredGrid * grid, const std::vector<vtkIdType> & triangles)
{
  const std::vector<vtkIdType> points = PointsOf(triangles);
  std::vector<vtkIdType>       faces;
  faces.reserve(triangles.size() / 3 * 4);
  for (std::size_t i = 0; i < triangles.size(); i += 3)
  {
    faces.insert(faces.end(), { 3, triangles[i], triangles[i + 1], triangles[i + 2] });
  }
  grid->InsertNextCell(VTK_POLYHEDRON,
                       static_cast<vtkIdType>(points.size()),
                       points.data(),
                       static_cast<vtkIdType>(triangles.size() / 3),
                       faces.data());
}
} // namespace bridge

/** \brief Makes a table with one row of statistics for each cell of the tissue, in ascending order of the labels.
 *
 * | column | type | meaning |
 * |---|---|---|
 * | `Label` (active scalars) | Int64 | label in the image |
 * | `CenterX`, `CenterY`, `CenterZ` | Float64 | barycentre in the image |
 * | `Volume` | Float64 | volume inside the cell's walls; meaningless where `IsClosed` is 0 |
 * | `ImageVolume` | Float64 | volume of the cell's voxels |
 * | `SurfaceArea` | Float64 | area of the cell's walls |
 * | `NumberOfNeighbors` | Int32 | cells that share a wall with it, the exterior not counted |
 * | `NumberOfTriangles`, `EulerCharacteristic` | Int32 | of its walls, as in CellSurface |
 * | `MinimumDihedralAngle` | Float64 | the least angle within it between two of its triangles, in degrees |
 * | `IsClosed` | UInt8 | as in CellSurface |
 * | `TouchesExterior`, `TouchesBorder` | UInt8 | 1 or 0: in the image, as in Cell |
 * | `NumberOfPieces`, `NumberOfVoxels`, `NumberOfStrayVoxels` | Int32, Int64, Int64 | in the image, as in Cell |
 * | `ExteriorArea`, `CutArea` | Float64 | area of its walls to the exterior, and of where the tissue is cut there |
 * | `Layer` | Int32 | 1 in the epidermis, 2 below it, ...; 0 where no wall leads there |
 * | `Sphericity` | Float64 | 1 for a ball, less for others |
 * | `Elongation`, `Flatness` | Float64 | the major axis over the middle one, the middle over the minor one |
 * | `MajorAxisLength`, `MajorAxis`, `MiddleAxisLength`, ... | Float64, 1 and 3 components | as in CellStatistics |
 * | `MeanCurvature`, `GaussianCurvature`, `MaximumCurvature`, `MinimumCurvature` | Float64 | of the tissue's surface at
 * a cell of the epidermis |
 *
 * Lengths are in the units of the image. What cannot be measured is not a number. A cell that has no walls has a row
 * too: its `NumberOfTriangles` is 0. `check` is the result of CheckCellSurfaces for `mesh` and `cells.size()`,
 * `statistics` that of MeasureTissue. \throws std::invalid_argument where these are for other numbers, or as
 * RequireConsistentIndices does. */
inline vtkSmartPointer<vtkTable>
MakeCellTable(const WallMesh & mesh, const std::vector<Cell> & cells, const CellSurfaceCheck & check,
              const TissueStatistics & statistics)
{
  const std::vector<VertexId> vertices = bridge::NumbersOf(ExteriorVertex + 1, cells.size());
  vtkSmartPointer<vtkTable>   table = vtkSmartPointer<vtkTable>::New();
  bridge::AddCellStatistics(table->GetRowData(), mesh, cells, check, statistics, vertices);
  return table;
}

/** \brief Makes a table with one row for each two cells of the tissue that share walls, in ascending order of the
 * labels: the edges of the graph of neighbours.
 *
 * | column | type | meaning |
 * |---|---|---|
 * | `Label0`, `Label1` | Int64 | labels of the two cells, ascending |
 * | `weight` | Float64 | area of their walls: the name that programs for graphs know |
 * | `NumberOfWalls` | Int32 | as two cells may have several |
 *
 * \throws std::invalid_argument where `statistics`, the result of MeasureTissue, is for other numbers, or as
 * RequireConsistentIndices does. */
inline vtkSmartPointer<vtkTable>
MakeNeighborTable(const WallMesh & mesh, const std::vector<Cell> & cells, const TissueStatistics & statistics)
{
  RequireConsistentIndices(mesh, static_cast<VertexId>(cells.size()));
  RequireStatisticsOf(mesh, cells, statistics);
  using Pair = std::pair<VertexPair, NeighborPair>;
  const auto              map = FindNeighborPairs(mesh, statistics.walls);
  const std::vector<Pair> pairs(map.begin(), map.end());
  const auto              table = vtkSmartPointer<vtkTable>::New();
  vtkFieldData * const    rows = table->GetRowData();
  for (int side = 0; side < 2; ++side)
  {
    bridge::AddColumn<bridge::LabelArray>(
      rows, side == 0 ? "Label0" : "Label1", pairs, [&](const Pair & pair) { return cells[pair.first[side]].label; });
  }
  bridge::AddColumn<vtkTypeFloat64Array>(rows, "weight", pairs, [](const Pair & pair) { return pair.second.area; });
  bridge::AddColumn<vtkTypeInt32Array>(
    rows, "NumberOfWalls", pairs, [](const Pair & pair) { return pair.second.numberOfWalls; });
  return table;
}

/** \brief Makes a grid of the cells of a tissue, one VTK_POLYHEDRON each.
 *
 * They are in ascending order of their number of points, and of their labels where that is equal: meshio, which sorts
 * polyhedra so but leaves their order otherwise, would give cells others' values.
 *
 * The points are those of MakeWallPolyData, the faces the triangles of the cell's walls, turned outwards. The cell
 * arrays are the columns of MakeCellTable. There is no array of text, so that meshio reads the file. A cell without a
 * triangle is left out; one that is not closed is kept, and its `IsClosed` is 0. `check` and `statistics` are those of
 * MakeCellTable. */
inline vtkSmartPointer<vtkUnstructuredGrid>
MakeCellGrid(const WallMesh & mesh, const std::vector<Cell> & cells, const CellSurfaceCheck & check,
             const TissueStatistics & statistics)
{
  RequireConsistentIndices(mesh, static_cast<VertexId>(cells.size()));
  std::vector<std::vector<vtkIdType>> trianglesOfCell(cells.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle &         triangle = mesh.triangles[t];
    const VertexPair &       sides = mesh.walls[mesh.wallOfTriangle[t]].cells;
    std::vector<vtkIdType> & first = trianglesOfCell[sides[0]];
    std::vector<vtkIdType> & second = trianglesOfCell[sides[1]];
    first.insert(first.end(), { triangle[0], triangle[1], triangle[2] });
    second.insert(second.end(), { triangle[0], triangle[2], triangle[1] });
  }

  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  std::vector<VertexId>                vertices;
  grid->SetPoints(bridge::MakeMeshPoints(mesh));
  std::vector<std::size_t> numberOfPoints(cells.size(), 0);
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    if (!trianglesOfCell[v].empty())
    {
      numberOfPoints[v] = bridge::PointsOf(trianglesOfCell[v]).size();
      vertices.push_back(static_cast<VertexId>(v));
    }
  }
  std::stable_sort(vertices.begin(), vertices.end(), [&numberOfPoints](VertexId a, VertexId b) {
    return numberOfPoints[a] < numberOfPoints[b];
  });
  for (const VertexId v : vertices)
  {
    bridge::InsertPolyhedron(grid, trianglesOfCell[v]);
  }
  bridge::AddCellStatistics(grid->GetCellData(), mesh, cells, check, statistics, vertices);
  return grid;
}
} // namespace tissue

#endif
