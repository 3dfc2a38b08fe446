/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueMeshEvaluation/WallMeshReader.h"

#include "TissueMeshEvaluation/MeshFile.h"
#include "TissueMeshEvaluation/SideLabels.h"
#include "TissueMeshEvaluation/TriangleOrientation.h"

#include <vtkCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

namespace tissue
{
namespace
{
constexpr Label Outside = -1;

/** A polygon, or the face of a cell, as triangles. */
struct Polygon
{
  std::vector<std::array<PointId, 3>> triangles;
  /** Its points, for comparison with those of others, ascending. */
  std::vector<PointId> key;
};

/** The first point at the place of each. */
std::vector<PointId>
FindPlaces(const std::vector<Point> & points)
{
  std::map<Point, PointId> firstAt;
  std::vector<PointId>     places;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const auto id = static_cast<PointId>(p);
    const bool isFinite = std::all_of(points[p].begin(), points[p].end(), [](double x) { return std::isfinite(x); });
    places.push_back(isFinite ? firstAt.emplace(points[p], id).first->second : id);
  }
  return places;
}

Polygon
TakePolygon(vtkCell * cell, const std::vector<PointId> & places)
{
  Polygon polygon;
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    polygon.key.push_back(places[static_cast<std::size_t>(cell->GetPointId(static_cast<int>(i)))]);
  }
  std::sort(polygon.key.begin(), polygon.key.end());
  const vtkNew<vtkIdList> ids;
  const vtkNew<vtkPoints> points;
  cell->Triangulate(0, ids, points);
  for (vtkIdType i = 0; i + 2 < ids->GetNumberOfIds(); i += 3)
  {
    polygon.triangles.push_back({ { static_cast<PointId>(ids->GetId(i)),
                                    static_cast<PointId>(ids->GetId(i + 1)),
                                    static_cast<PointId>(ids->GetId(i + 2)) } });
  }
  return polygon;
}

/** Collects the surfaces of cells: polygons with the label that is behind them. */
class SurfacePolygons
{
public:
  void
  Add(Polygon polygon, Label label)
  {
    Sides & sides = m_SidesOf[polygon.key];
    sides.labels.push_back(label);
    if (sides.labels.size() == 1)
    {
      sides.triangles = std::move(polygon.triangles);
    }
  }

  /** \throws std::runtime_error where there are several labels, but none has a wall with another one. */
  void
  AddTo(TrianglesOfLabels & mesh) const
  {
    std::set<Label> all;
    std::size_t     numberOfWalls = 0;
    for (const auto & [key, sides] : m_SidesOf)
    {
      all.insert(sides.labels.begin(), sides.labels.end());
      const Label second = sides.labels.size() == 1 ? Outside : sides.labels[1];
      numberOfWalls += sides.labels.size() > 1 && second != sides.labels[0] ? 1 : 0;
      for (const auto & triangle : sides.triangles)
      {
        if (second != sides.labels[0])
        {
          mesh.triangles.push_back({ triangle, { { sides.labels[0], second } } });
        }
      }
    }
    if (all.size() > 1 && numberOfWalls == 0)
    {
      throw std::runtime_error("has surfaces of " + std::to_string(all.size()) +
                               " labels that share no polygon: walls, which two cells have in common, are what is "
                               "judged");
    }
  }

private:
  struct Sides
  {
    std::vector<Label>                  labels;
    std::vector<std::array<PointId, 3>> triangles;
  };

  std::map<std::vector<PointId>, Sides> m_SidesOf;
};

WallMeshFile
TakeMesh(vtkDataSet * data, const SideLabels & labels, const std::set<Label> & exterior)
{
  WallMeshFile        file;
  TrianglesOfLabels & mesh = file.mesh;
  mesh.points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    data->GetPoint(static_cast<vtkIdType>(p), mesh.points[p].data());
  }
  const std::vector<PointId> places = FindPlaces(mesh.points);
  SurfacePolygons            surfaces;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    vtkCell * const cell = data->GetCell(c);
    const auto &    sides = labels.labels[static_cast<std::size_t>(c)];
    const int       dimension = cell->GetCellDimension();
    if (dimension == 2 && labels.areOfBothSides)
    {
      for (const auto & triangle : TakePolygon(cell, places).triangles)
      {
        mesh.triangles.push_back({ triangle, sides });
      }
    }
    else if (dimension == 2)
    {
      surfaces.Add(TakePolygon(cell, places), sides[0]);
    }
    else if (dimension == 3 && !labels.areOfBothSides)
    {
      for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
      {
        surfaces.Add(TakePolygon(cell->GetFace(f), places), sides[0]);
      }
    }
  }
  surfaces.AddTo(mesh);
  file.warnings = OrientByLabels(mesh, places, exterior);
  return file;
}
} // namespace

WallMeshFile
ReadWallMesh(const std::string & path, const std::string & labelArray, const std::vector<Label> & exteriorLabels)
{
  const vtkSmartPointer<vtkDataSet> data = ReadMeshFile(path);
  if (data->GetNumberOfCells() == 0)
  {
    throw std::runtime_error(path + ": has no polygon");
  }
  const SideLabels labels = FindSideLabels(data, labelArray, path);
  std::set<Label>  exterior(exteriorLabels.begin(), exteriorLabels.end());
  exterior.insert(Outside);
  try
  {
    WallMeshFile file = TakeMesh(data, labels, exterior);
    if (file.mesh.triangles.empty())
    {
      throw std::runtime_error("has no polygon between two labels");
    }
    return file;
  }
  catch (const std::runtime_error & error)
  {
    throw std::runtime_error(path + ": " + error.what() + " (labels of the array " + labels.name + ')');
  }
}
} // namespace tissue
