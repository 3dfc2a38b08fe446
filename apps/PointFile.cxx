/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "PointFile.h"

#include "VTKFiles.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
using Row = std::vector<std::string>;

[[noreturn]] void
Refuse(const std::string & path, const std::string & reason)
{
  throw std::runtime_error("Cannot read points from '" + path + "': " + reason);
}

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

std::string
Trim(const std::string & text)
{
  const char * const blanks = " \t\r\"";
  const auto         begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

Row
SplitAtCommas(const std::string & line)
{
  Row                cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');)
  {
    cells.push_back(Trim(cell));
  }
  return cells;
}

/** Nothing where the text is no number, whatever the locale. */
std::optional<double>
ToNumber(const std::string & text)
{
  double       number = 0.0;
  const char * end = text.data() + text.size();
  const char * begin = !text.empty() && text.front() == '+' ? text.data() + 1 : text.data();
  const auto   result = std::from_chars(begin, end, number);
  return result.ec == std::errc() && result.ptr == end ? std::optional<double>(number) : std::nullopt;
}

/** Where the coordinates are. */
std::optional<std::array<std::size_t, 3>>
FindCoordinates(const Row & header)
{
  const auto find = [&header](const auto & hasName) -> std::optional<std::array<std::size_t, 3>> {
    std::array<std::size_t, 3> columns{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const char letter = "xyz"[axis];
      const auto at = std::find_if(
        header.begin(), header.end(), [&](const std::string & name) { return hasName(ToLower(name), letter); });
      if (at == header.end())
      {
        return std::nullopt;
      }
      columns[axis] = static_cast<std::size_t>(at - header.begin());
    }
    return columns;
  };
  const auto endsWith = [](const std::string & name, const std::string & end) {
    return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  auto columns = find([](const std::string & name, char letter) { return name == std::string(1, letter); });
  if (!columns)
  {
    columns =
      find([](const std::string & name, char letter) { return name.rfind(std::string(1, letter) + "_", 0) == 0; });
  }
  if (!columns)
  {
    columns = find([&](const std::string & name, char letter) {
      return endsWith(name, std::string("_") + letter) || name == std::string("center") + letter;
    });
  }
  return columns;
}

struct NumberedRow
{
  std::size_t line;
  Row         cells;
};

/** Coordinates, then the other columns, of which one with some text is dropped. */
PointTable
ToTable(const std::string & path, const Row & header, const std::vector<NumberedRow> & rows)
{
  const auto coordinates = FindCoordinates(header);
  if (!coordinates)
  {
    Refuse(path, "the header has no columns x, y and z");
  }
  PointTable                       table;
  std::vector<bool>                isNumeric(header.size(), true);
  std::vector<std::vector<double>> values(header.size());
  for (const NumberedRow & row : rows)
  {
    if (row.cells.size() < header.size() &&
        row.cells.size() <= *std::max_element(coordinates->begin(), coordinates->end()))
    {
      Refuse(path,
             "line " + std::to_string(row.line) + " has " + std::to_string(row.cells.size()) + " columns, the header " +
               std::to_string(header.size()));
    }
    Point point{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::string & text = row.cells[(*coordinates)[axis]];
      const auto          number = ToNumber(text);
      if (!number || !std::isfinite(*number))
      {
        Refuse(path,
               "'" + text + "' in line " + std::to_string(row.line) + ", column " + header[(*coordinates)[axis]] +
                 ", is no finite number");
      }
      point[axis] = *number;
    }
    table.points.push_back(point);
    for (std::size_t c = 0; c < header.size(); ++c)
    {
      const auto number = c < row.cells.size() ? ToNumber(row.cells[c]) : std::nullopt;
      isNumeric[c] = isNumeric[c] && number;
      values[c].push_back(number.value_or(0.0));
    }
  }
  for (std::size_t c = 0; c < header.size(); ++c)
  {
    if (isNumeric[c] && std::find(coordinates->begin(), coordinates->end(), c) == coordinates->end())
    {
      table.columns.emplace_back(header[c], std::move(values[c]));
    }
  }
  return table;
}

std::ifstream
Open(const std::string & path)
{
  std::ifstream stream(path);
  if (!stream)
  {
    Refuse(path, "there is no such file, or it may not be read");
  }
  return stream;
}

PointTable
ReadTable(const std::string & path)
{
  std::ifstream            stream = Open(path);
  Row                      header;
  std::vector<NumberedRow> rows;
  std::size_t              number = 0;
  for (std::string line; std::getline(stream, line);)
  {
    ++number;
    if (number == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0)
    {
      line.erase(0, 3);
    }
    if (Trim(line).empty())
    {
      continue;
    }
    if (header.empty())
    {
      header = SplitAtCommas(line);
    }
    else
    {
      rows.push_back({ number, SplitAtCommas(line) });
    }
  }
  if (header.empty())
  {
    Refuse(path, "it is empty");
  }
  return ToTable(path, header, rows);
}

PointTable
ReadFiducials(const std::string & path)
{
  std::ifstream            stream = Open(path);
  bool                     isLps = false;
  Row                      header{ "id", "x", "y", "z", "ow", "ox", "oy", "oz", "vis", "sel", "lock", "label" };
  std::vector<NumberedRow> rows;
  std::size_t              number = 0;
  for (std::string line; std::getline(stream, line);)
  {
    ++number;
    const auto equals = line.find('=');
    if (!line.empty() && line.front() == '#')
    {
      const std::string value = equals != std::string::npos ? Trim(line.substr(equals + 1)) : "";
      if (line.find("CoordinateSystem") != std::string::npos)
      {
        isLps = value == "LPS" || value == "1";
        if (!isLps && value != "RAS" && value != "0")
        {
          Refuse(path,
                 "the coordinate system '" + value + "' in line " + std::to_string(number) + " is neither RAS nor LPS");
        }
      }
      else if (line.find("columns") != std::string::npos)
      {
        header = SplitAtCommas(value);
      }
    }
    else if (!Trim(line).empty())
    {
      rows.push_back({ number, SplitAtCommas(line) });
    }
  }
  PointTable table = ToTable(path, header, rows);
  // Of a fiducial only its label tells something of the point.
  const auto isLabel = [](const PointTable::Column & column) { return column.first == "label"; };
  table.columns.erase(table.columns.begin(), std::find_if(table.columns.begin(), table.columns.end(), isLabel));
  table.columns.resize(std::min<std::size_t>(table.columns.size(), 1));
  for (Point & point : table.points)
  {
    point[0] = isLps ? point[0] : -point[0];
    point[1] = isLps ? point[1] : -point[1];
  }
  return table;
}

PointTable
ReadPolyData(const std::string & path)
{
  Open(path);
  vtkNew<vtkXMLPolyDataReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    Refuse(path, "it is no vtkPolyData");
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData * const data = reader->GetOutput();
  PointTable          table;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Point point;
    data->GetPoint(i, point.data());
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
    {
      Refuse(path, "point " + std::to_string(i) + " is not finite");
    }
    table.points.push_back(point);
  }
  for (int a = 0; a < data->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray * const array = data->GetPointData()->GetArray(a);
    if (array != nullptr && array->GetName() != nullptr && array->GetNumberOfComponents() == 1)
    {
      std::vector<double> values;
      for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      {
        values.push_back(array->GetComponent(i, 0));
      }
      table.columns.emplace_back(array->GetName(), std::move(values));
    }
  }
  return table;
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
  std::ofstream stream(path);
  stream << "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n"
            "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
         << std::setprecision(10);
  const auto * const labels = table.FindColumn("label");
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

PointTable
ReadPoints(const std::string & path)
{
  const std::string format = Extension(path);
  if (format == ".csv")
  {
    return ReadTable(path);
  }
  if (format == ".fcsv")
  {
    return ReadFiducials(path);
  }
  if (format == ".vtp")
  {
    return ReadPolyData(path);
  }
  Refuse(path, "points are read from .csv, .fcsv and .vtp");
}

std::string
RequirePointFormat(const std::string & path)
{
  const std::string format = Extension(path);
  if (format != ".csv" && format != ".fcsv" && format != ".vtp")
  {
    throw std::runtime_error("Cannot write points to '" + path + "': they are written to .csv, .fcsv and .vtp");
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
