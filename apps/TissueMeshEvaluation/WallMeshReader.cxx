/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueMeshEvaluation/WallMeshReader.h"

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

#include <cmath>
#include <fstream>
#include <sstream>
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

vtkDataArray *
RequireLabelArray(vtkPolyData * data, const std::string & name, const std::string & path)
{
  const vtkIdType      numberOfTriangles = data->GetNumberOfPolys();
  vtkDataArray * const array = data->GetCellData()->GetArray(name.c_str());
  if (!array)
  {
    Fail(path, "has no numeric cell array " + name + " (--labelArray)");
  }
  if (array->GetNumberOfComponents() != 2)
  {
    Fail(path, "array " + name + " has " + std::to_string(array->GetNumberOfComponents()) + " components, must have 2");
  }
  if (array->GetNumberOfTuples() != numberOfTriangles)
  {
    Fail(path,
         "array " + name + " has labels for " + std::to_string(array->GetNumberOfTuples()) + " of the " +
           std::to_string(numberOfTriangles) + " triangles");
  }
  return array;
}

/** Refuses what is no label, and what is too large for VTK's numbers to tell from its neighbours. */
Label
ToLabel(double value, vtkIdType triangle, const std::string & path)
{
  constexpr double limit = 9007199254740992.0;
  if (!(std::abs(value) < limit) || value != std::floor(value))
  {
    std::ostringstream text;
    text << "triangle " << triangle << " has label " << value << ", labels are whole numbers below " << limit;
    Fail(path, text.str());
  }
  return static_cast<Label>(value);
}
} // namespace

TrianglesOfLabels
ReadWallMesh(const std::string & path, const std::string & labelArray)
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
  TrianglesOfLabels    mesh;
  mesh.points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    data->GetPoint(static_cast<vtkIdType>(p), mesh.points[p].data());
  }
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
    TrianglesOfLabels::Triangle triangle;
    for (int i = 0; i < 3; ++i)
    {
      triangle.points[i] = static_cast<PointId>(polygon->GetId(i));
    }
    for (int side = 0; side < 2; ++side)
    {
      triangle.labels[side] = ToLabel(labels->GetComponent(t, side), t, path);
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}
} // namespace tissue
