/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKCellSurfaces_h
#define TissueTessellationVTKCellSurfaces_h

#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationVTK/Cells.h"

#include <vtkPolyData.h>

#include <cmath>
#include <map>

namespace tissue
{
/** The surface of a cell by points of its own. */
struct OwnSurface
{
  /** Points of the mesh, each once, in the order of the triangles. */
  std::vector<PointId> points;
  /** Indices of these, turned outwards. */
  std::vector<Triangle> triangles;
};

/** The surface of each vertex of the adjacency complex; that of the exterior is turned away from it. */
inline std::vector<OwnSurface>
CollectOwnSurfaces(const WallMesh & mesh, std::size_t numberOfVertices)
{
  RequireConsistentIndices(mesh, static_cast<VertexId>(numberOfVertices));
  std::vector<OwnSurface> surfaces(numberOfVertices);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & [a, b, c] = mesh.triangles[t];
    const VertexPair & sides = mesh.walls[mesh.wallOfTriangle[t]].cells;
    surfaces[sides[0]].triangles.push_back({ { a, b, c } });
    surfaces[sides[1]].triangles.push_back({ { a, c, b } });
  }
  for (OwnSurface & surface : surfaces)
  {
    std::map<PointId, PointId> numbers;
    for (Triangle & triangle : surface.triangles)
    {
      for (PointId & p : triangle)
      {
        const auto [at, isNew] = numbers.emplace(p, static_cast<PointId>(surface.points.size()));
        if (isNew)
        {
          surface.points.push_back(p);
        }
        p = at->second;
      }
    }
  }
  return surfaces;
}

namespace bridge
{
/** The sum of the triangles' normals, by their areas, at each point; of length 1, or 0 where they cancel. */
inline std::vector<Point>
ComputePointNormals(const std::vector<Point> & points, const std::vector<Triangle> & triangles)
{
  std::vector<Point> normals(points.size(), Point{ { 0.0, 0.0, 0.0 } });
  for (const Triangle & triangle : triangles)
  {
    const Point & a = points[triangle[0]];
    const Point   normal = Cross(points[triangle[1]] - a, points[triangle[2]] - a);
    for (const PointId p : triangle)
    {
      normals[p] = normals[p] + normal;
    }
  }
  for (Point & normal : normals)
  {
    const double length = std::sqrt(Dot(normal, normal));
    normal = length > 0.0 ? (1.0 / length) * normal : normal;
  }
  return normals;
}

inline vtkSmartPointer<vtkTypeFloat64Array>
MakeVectors(const char * name, const std::vector<Point> & vectors)
{
  auto array = MakeArray<vtkTypeFloat64Array>(name, 3, static_cast<vtkIdType>(vectors.size()));
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(i), vectors[i].data());
  }
  return array;
}
} // namespace bridge

/** \brief Makes the closed surface of each cell, its triangles turned outwards: a wall of two cells is there twice, and
 * no two cells share a point, so that each can be moved, hidden or saved by itself.
 *
 * In ascending order of the labels. The cell arrays are the columns of MakeCellTable, on every triangle of the cell.
 * The point arrays are `Normals`, outwards and of length 1, and `FromCenter`, the way from the mean of all cells'
 * centres to the centre of the point's cell: to move all points by a share of it takes the tissue apart. The field
 * array `SPACE` is `LPS`. `check` and `statistics` are those of MakeCellTable. */
inline vtkSmartPointer<vtkPolyData>
MakeCellSurfaces(const WallMesh & mesh, const std::vector<Cell> & cells, const CellSurfaceCheck & check,
                 const TissueStatistics & statistics)
{
  const std::vector<OwnSurface> surfaces = CollectOwnSurfaces(mesh, cells.size());
  Point                         middle{ { 0.0, 0.0, 0.0 } };
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    middle = middle + (1.0 / static_cast<double>(cells.size() - 1)) * cells[v].center;
  }
  std::vector<Point>    points;
  std::vector<Point>    ways;
  std::vector<Triangle> triangles;
  std::vector<VertexId> vertices;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    const auto first = static_cast<PointId>(points.size());
    for (const PointId p : surfaces[v].points)
    {
      points.push_back(mesh.points[p]);
      ways.push_back(cells[v].center - middle);
    }
    for (const auto & [a, b, c] : surfaces[v].triangles)
    {
      triangles.push_back({ { first + a, first + b, first + c } });
      vertices.push_back(static_cast<VertexId>(v));
    }
  }
  auto       data = vtkSmartPointer<vtkPolyData>::New();
  const auto position = vtkSmartPointer<vtkPoints>::New();
  position->SetData(bridge::MakeVectors("Points", points));
  data->SetPoints(position);
  const auto polygons = vtkSmartPointer<vtkCellArray>::New();
  for (const auto & [a, b, c] : triangles)
  {
    polygons->InsertNextCell({ a, b, c });
  }
  data->SetPolys(polygons);
  bridge::AddCellStatistics(data->GetCellData(), mesh, cells, check, statistics, vertices);
  const auto normals = bridge::MakeVectors("Normals", bridge::ComputePointNormals(points, triangles));
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->AddArray(bridge::MakeVectors("FromCenter", ways));
  bridge::AddCoordinateSystem(data);
  return data;
}
} // namespace tissue

#endif
