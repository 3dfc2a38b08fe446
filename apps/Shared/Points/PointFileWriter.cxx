/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointFileWriter.h"

#include "Shared/Files/VTKFiles.h"
#include "Shared/Points/SlicerMarkups.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <locale>
#include <stdexcept>

namespace tissue
{
namespace
{
std::string
ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string
Extension(const std::string & path)
{
  return ToLower(std::filesystem::path(path).extension().string());
}

void
AddColumn(const std::string & name, const std::vector<double> & values, vtkFieldData * data)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  data->AddArray(array);
}

void
WriteTable(const PointTable & table, const std::string & path)
{
  vtkNew<vtkTable> rows;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::vector<double> coordinates;
    for (const Point & point : table.points)
    {
      coordinates.push_back(point[axis]);
    }
    AddColumn(std::string(1, "xyz"[axis]), coordinates, rows->GetRowData());
  }
  for (const auto & [name, values] : table.columns)
  {
    AddColumn(name, values, rows->GetRowData());
  }
  WriteCSV(rows, path);
}

void
WriteFiducials(const PointTable & table, const std::string & path)
{
  std::ofstream stream(path, std::ios::binary);
  // Whatever the locale, and as many digits as it takes to read the same numbers.
  stream.imbue(std::locale::classic());
  stream << "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n"
            "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
         << std::setprecision(std::numeric_limits<double>::max_digits10);
  const auto * const labels = table.FindColumn("Label");
  for (std::size_t i = 0; i < table.points.size(); ++i)
  {
    const Point & p = table.points[i];
    stream << i + 1 << ',' << p[0] << ',' << p[1] << ',' << p[2] << ",0,0,0,1,1,1,0,";
    stream << (labels != nullptr ? (*labels)[i] : static_cast<double>(i + 1)) << ",,\n";
  }
  stream.close();
  if (!stream)
  {
    throw std::runtime_error("the file could not be written in full");
  }
}

void
WritePolyData(const PointTable & table, const std::string & path)
{
  vtkNew<vtkPolyData>  data;
  vtkNew<vtkPoints>    points;
  vtkNew<vtkCellArray> vertices;
  points->SetDataTypeToDouble();
  for (const Point & p : table.points)
  {
    const vtkIdType id = points->InsertNextPoint(p.data());
    vertices->InsertNextCell(1, &id);
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
  for (const auto & [name, values] : table.columns)
  {
    AddColumn(name, values, data->GetPointData());
  }
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue("LPS");
  data->GetFieldData()->AddArray(space);
  WriteXML(data, path);
}
} // namespace

const std::vector<double> *
PointTable::FindColumn(const std::string & name) const
{
  const auto at =
    std::find_if(columns.begin(), columns.end(), [&name](const Column & column) { return column.first == name; });
  return at != columns.end() ? &at->second : nullptr;
}

std::string
RequirePointFormat(const std::string & path)
{
  const std::string format = Extension(path);
  if (format != ".csv" && format != ".fcsv" && format != ".json" && format != ".vtp")
  {
    throw std::runtime_error("Cannot write points to '" + path +
                             "': they are written to .csv, .fcsv, .mrk.json and .vtp");
  }
  return format;
}

void
WritePoints(const PointTable & table, const std::string & path, const std::string & format)
{
  if (format == ".vtp")
  {
    WritePolyData(table, path);
  }
  else if (format == ".json")
  {
    WriteMarkupsJson(table, path);
  }
  else if (format == ".fcsv")
  {
    WriteFiducials(table, path);
  }
  else
  {
    WriteTable(table, path);
  }
}
} // namespace tissue
