/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "WallMeshInput.h"

#include "TissueTessellationCore/LabelledTriangles.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace tissue
{
namespace
{
[[noreturn]] void
Fail(const std::string & path, const std::string & what)
{
  throw std::runtime_error(path + ": " + what);
}

vtkSmartPointer<vtkPolyData>
ReadPolyData(const std::string & path)
{
  if (!std::ifstream(path))
  {
    Fail(path, "there is no such file, or it cannot be read");
  }
  // What is wrong is said in one line, below.
  vtkObject::GlobalWarningDisplayOff();
  const vtkNew<vtkXMLPolyDataReader> xml;
  if (xml->CanReadFile(path.c_str()))
  {
    xml->SetFileName(path.c_str());
    xml->Update();
    if (xml->GetErrorCode() != 0)
    {
      Fail(path, "is damaged or cut off");
    }
    return xml->GetOutput();
  }
  const vtkNew<vtkPolyDataReader> legacy;
  legacy->SetFileName(path.c_str());
  if (!legacy->IsFilePolyData())
  {
    Fail(path, "is no VTK file of polygons (.vtp, or .vtk of POLYDATA)");
  }
  legacy->Update();
  return legacy->GetOutput();
}

VertexId
VertexOfLabel(Label label, const JunctionSet & junctions, const std::string & path)
{
  const std::vector<Cell> & cells = junctions.cells;
  const auto                at = std::lower_bound(
    cells.begin() + 1, cells.end(), label, [](const Cell & cell, Label wanted) { return cell.label < wanted; });
  if (at != cells.end() && at->label == label)
  {
    return static_cast<VertexId>(at - cells.begin());
  }
  if (label != cells[ExteriorVertex].label)
  {
    Fail(path,
         "has label " + std::to_string(label) + ", which the image has not; its exterior label is " +
           std::to_string(cells[ExteriorVertex].label) + " (--exteriorLabel)");
  }
  return ExteriorVertex;
}

vtkDataArray *
RequireLabelArray(vtkPolyData * data, const std::string & name, const std::string & path)
{
  vtkDataArray * const array = data->GetCellData()->GetArray(name.c_str());
  if (!array)
  {
    Fail(path, "has no numeric cell array " + name + " (--labelArray)");
  }
  if (array->GetNumberOfComponents() != 2)
  {
    Fail(path, "array " + name + " has " + std::to_string(array->GetNumberOfComponents()) + " components, must have 2");
  }
  return array;
}

std::vector<Point>
ReadPoints(vtkPolyData * data, const std::string & path)
{
  std::vector<Point> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    data->GetPoint(static_cast<vtkIdType>(p), points[p].data());
    if (!std::all_of(points[p].begin(), points[p].end(), [](double x) { return std::isfinite(x); }))
    {
      Fail(path, "point " + std::to_string(p) + " is not finite");
    }
  }
  return points;
}
} // namespace

WallMesh
ReadWallMesh(const std::string & path, const std::string & labelArray, const JunctionSet & junctions)
{
  const vtkSmartPointer<vtkPolyData> data = ReadPolyData(path);
  const vtkIdType                    numberOfTriangles = data->GetNumberOfPolys();
  if (numberOfTriangles == 0 || numberOfTriangles != data->GetNumberOfCells())
  {
    Fail(path,
         "has " + std::to_string(numberOfTriangles) + " polygons among " + std::to_string(data->GetNumberOfCells()) +
           " cells, must have nothing but triangles");
  }
  vtkDataArray * const labels = RequireLabelArray(data, labelArray, path);
  LabelledTriangles    mesh;
  mesh.points = ReadPoints(data, path);
  const vtkNew<vtkIdList> polygon;
  for (vtkIdType t = 0; t < numberOfTriangles; ++t)
  {
    data->GetPolys()->GetCellAtId(t, polygon);
    if (polygon->GetNumberOfIds() != 3)
    {
      Fail(path,
           "polygon " + std::to_string(t) + " has " + std::to_string(polygon->GetNumberOfIds()) +
             " corners, must have 3");
    }
    LabelledTriangles::Triangle triangle;
    for (int i = 0; i < 3; ++i)
    {
      triangle.points[i] = static_cast<PointId>(polygon->GetId(i));
    }
    for (int side = 0; side < 2; ++side)
    {
      triangle.cells[side] = VertexOfLabel(static_cast<Label>(labels->GetComponent(t, side)), junctions, path);
    }
    mesh.triangles.push_back(triangle);
  }
  try
  {
    return MakeWallMesh(mesh);
  }
  catch (const std::invalid_argument & error)
  {
    Fail(path, error.what());
  }
}
} // namespace tissue
