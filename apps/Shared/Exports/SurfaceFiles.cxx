/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Exports/SurfaceFiles.h"

#include "Shared/Exports/CellComplexPly.h"
#include "Shared/Files/NumberFile.h"
#include "Shared/Files/VTKFiles.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace tissue
{
namespace
{
std::size_t
CountPoints(const std::vector<ExportedCell> & cells)
{
  std::size_t number = 0;
  for (const ExportedCell & cell : cells)
  {
    number += cell.points.size();
  }
  return number;
}

std::size_t
CountTriangles(const std::vector<ExportedCell> & cells)
{
  std::size_t number = 0;
  for (const ExportedCell & cell : cells)
  {
    number += cell.triangles.size();
  }
  return number;
}
} // namespace

void
WriteFaceLabelPly(const std::vector<ExportedCell> & cells, const std::string & path)
{
  NumberFile file(path);
  file << "ply\nformat ascii 1.0\nelement vertex " << CountPoints(cells)
       << "\nproperty float x\nproperty float y\nproperty float z\nproperty int label\nelement face "
       << CountTriangles(cells) << "\nproperty list uchar int vertex_index\nproperty int label\nend_header\n";
  for (const ExportedCell & cell : cells)
  {
    for (const Point & point : cell.points)
    {
      file << point << ' ' << ToPlyLabel(cell.label) << '\n';
    }
  }
  std::size_t first = 0;
  for (const ExportedCell & cell : cells)
  {
    for (const auto & [a, b, c] : cell.triangles)
    {
      file << "3 " << first + a << ' ' << first + b << ' ' << first + c << ' ' << cell.label << '\n';
    }
    first += cell.points.size();
  }
  file.Close();
}

void
WriteWavefront(const std::vector<ExportedCell> & cells, const std::string & path)
{
  NumberFile  file(path);
  std::size_t first = 1;
  for (const ExportedCell & cell : cells)
  {
    file << "g cell_" << cell.label << '\n';
    for (const Point & point : cell.points)
    {
      file << "v " << point << '\n';
    }
    for (const auto & [a, b, c] : cell.triangles)
    {
      file << "f " << first + a << ' ' << first + b << ' ' << first + c << '\n';
    }
    first += cell.points.size();
  }
  file.Close();
}

void
WriteStl(const std::vector<ExportedCell> & cells, const std::string & path)
{
  const vtkNew<vtkPoints>    points;
  const vtkNew<vtkCellArray> polygons;
  for (const ExportedCell & cell : cells)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Point & point : cell.points)
    {
      points->InsertNextPoint(point.data());
    }
    for (const auto & [a, b, c] : cell.triangles)
    {
      polygons->InsertNextCell({ first + a, first + b, first + c });
    }
  }
  const vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polygons);
  WriteStl(data, path);
}
} // namespace tissue
