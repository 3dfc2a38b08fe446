/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Page/PageFile.h"

#include "PageTemplate.h"
#include "Shared/Files/ColumnUnit.h"
#include "Shared/Files/TableColumns.h"
#include "Shared/Files/VTKFiles.h"
#include "TissueTessellationCore/Geometry/Box.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <vtkBase64Utilities.h>
#include <vtkDataArray.h>
#include <vtkTable.h>

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace tissue
{
namespace
{
using Json = nlohmann::ordered_json;

template <typename TValue>
std::string
ToBase64(const std::vector<TValue> & values)
{
  const std::size_t size = values.size() * sizeof(TValue);
  std::string       text((size + 2) / 3 * 4, '=');
  vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char *>(values.data()),
                             static_cast<unsigned long>(size),
                             reinterpret_cast<unsigned char *>(&text[0]));
  return text;
}

void
RequireConsistentNumbers(const PageContent & content)
{
  const auto rows = static_cast<std::size_t>(content.cells->GetNumberOfRows());
  if (content.colors.size() != rows + 1)
  {
    throw std::invalid_argument("Page: there are " + std::to_string(content.colors.size()) +
                                " colours, must be one more than the " + std::to_string(rows) + " cells");
  }
  for (const WallMesh::Wall & wall : content.walls.walls)
  {
    for (const VertexId v : wall.cells)
    {
      if (v < 0 || static_cast<std::size_t>(v) > rows)
      {
        throw std::invalid_argument("Page: a cell of a wall is " + std::to_string(v) + ", must be from 0 to " +
                                    std::to_string(rows));
      }
    }
  }
}

Point
MiddleOf(const std::vector<Point> & points)
{
  if (points.empty())
  {
    return { { 0.0, 0.0, 0.0 } };
  }
  Box box{ points.front(), points.front() };
  for (const Point & point : points)
  {
    Extend(box, point);
  }
  return 0.5 * (box.lower + box.upper);
}

void
AddMesh(const WallMesh & mesh, Json & json)
{
  const Point        origin = MiddleOf(mesh.points);
  std::vector<float> points;
  for (const Point & point : mesh.points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      points.push_back(static_cast<float>(point[axis] - origin[axis]));
    }
  }
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> walls;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    triangles.insert(triangles.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    if (t == 0 || mesh.wallOfTriangle[t] != mesh.wallOfTriangle[t - 1])
    {
      for (const VertexId v : mesh.walls[mesh.wallOfTriangle[t]].cells)
      {
        walls.push_back(static_cast<std::uint32_t>(v));
      }
      walls.push_back(0);
    }
    ++walls.back();
  }
  json["origin"] = origin;
  json["points"] = ToBase64(points);
  json["triangles"] = ToBase64(triangles);
  json["walls"] = ToBase64(walls);
}

std::string
KindOf(const TableColumn & column)
{
  if (column.name == "Label")
  {
    return "label";
  }
  switch (TypeOf(column))
  {
    case ValueType::Text:
      return "text";
    case ValueType::Number:
      return "number";
    default:
      break;
  }
  if (column.array->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    return "flag";
  }
  return column.name == "Layer" ? "category" : "count";
}

Json
ColumnToJson(const TableColumn & column, const std::string & length)
{
  const std::string kind = KindOf(column);
  const vtkIdType   rows = column.array->GetNumberOfTuples();
  Json              json{ { "name", column.name }, { "unit", ColumnUnit(column.name, length) }, { "kind", kind } };
  if (kind == "number")
  {
    std::vector<float>   values;
    vtkDataArray * const array = vtkDataArray::SafeDownCast(column.array);
    for (vtkIdType row = 0; row < rows; ++row)
    {
      values.push_back(static_cast<float>(array->GetComponent(row, column.component)));
    }
    json["values"] = ToBase64(values);
    return json;
  }
  Json values = Json::array();
  for (vtkIdType row = 0; row < rows; ++row)
  {
    // A label can have more digits than a number of JavaScript.
    const std::string text = ToText(column, row);
    values.push_back(kind == "label" || kind == "text" ? Json(text) : Json(std::stoll(text)));
  }
  json["values"] = values;
  return json;
}
} // namespace

std::string
MakePageData(const PageContent & content)
{
  RequireConsistentNumbers(content);
  const std::string         length = LengthSymbol(content.lengthUnit);
  std::vector<std::uint8_t> colors;
  for (std::size_t v = ExteriorVertex + 1; v < content.colors.size(); ++v)
  {
    colors.insert(colors.end(), content.colors[v].begin(), content.colors[v].end());
  }
  Json columns = Json::array();
  for (const TableColumn & column : ListColumns(content.cells))
  {
    columns.push_back(ColumnToJson(column, length));
  }
  Json json{ { "unit", length } };
  AddMesh(content.walls, json);
  json["colors"] = ToBase64(colors);
  json["columns"] = columns;
  json["report"] = content.report;
  // Text of files may be of any encoding.
  const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string       escaped;
  escaped.reserve(text.size());
  for (const char c : text)
  {
    c == '<' ? escaped += "\\u003c" : escaped += c;
  }
  return escaped;
}

void
WritePage(const PageContent & content, const std::string & path)
{
  const std::string page = PageTemplate;
  const std::string place = "@TISSUE_DATA@";
  const std::size_t begin = page.find(place);
  if (begin == std::string::npos)
  {
    throw std::runtime_error("the page's template has no place for data");
  }
  WriteBytes(page.substr(0, begin) + MakePageData(content) + page.substr(begin + place.size()), path);
}
} // namespace tissue
