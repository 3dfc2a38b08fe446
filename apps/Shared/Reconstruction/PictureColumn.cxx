/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/PictureColumn.h"

#include "Shared/Files/TableColumns.h"

#include <vtkDataArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <limits>
#include <map>

namespace tissue
{
namespace
{
/** The unit of a statistic, by the power of the length in it. */
std::string
UnitOf(const std::string & column, const std::string & length)
{
  static const std::map<std::string, int> powers{
    { "CenterX", 1 },           { "CenterY", 1 },           { "CenterZ", 1 },           { "Volume", 3 },
    { "ImageVolume", 3 },       { "SurfaceArea", 2 },       { "ExteriorArea", 2 },      { "CutArea", 2 },
    { "MajorAxisLength", 1 },   { "MiddleAxisLength", 1 },  { "MinorAxisLength", 1 },   { "MeanCurvature", -1 },
    { "MaximumCurvature", -1 }, { "MinimumCurvature", -1 }, { "GaussianCurvature", -2 }
  };
  static const std::map<int, std::string> exponents{ { 1, "" }, { 2, "²" }, { 3, "³" } };
  const auto                              power = powers.find(column);
  if (power == powers.end())
  {
    return column == "MinimumDihedralAngle" ? "degrees" : "";
  }
  return (power->second < 0 ? "1/" : "") + length + exponents.at(std::abs(power->second));
}
} // namespace

std::optional<PictureValues>
MakePictureValues(vtkTable * table, const std::string & column, const std::vector<Cell> & cells,
                  const std::string & lengthUnit)
{
  const std::vector<TableColumn> columns = ListColumns(table);
  const auto                     find = [&columns](const std::string & name) {
    return std::find_if(columns.begin(), columns.end(), [&name](const TableColumn & c) { return c.name == name; });
  };
  const auto labels = find("Label");
  const auto found = find(column);
  if (column == "Label" || column == "Name" || found == columns.end())
  {
    return std::nullopt;
  }
  std::map<Label, std::size_t> vertexOf;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    vertexOf[cells[v].label] = v;
  }
  const std::string unit = UnitOf(column, lengthUnit);
  PictureValues     values{ column + (unit.empty() ? "" : " (" + unit + ")"), {}, {} };
  const bool        isText = TypeOf(*found) == ValueType::Text;
  values.numbers.resize(isText ? 0 : cells.size(), std::numeric_limits<double>::quiet_NaN());
  values.texts.resize(isText ? cells.size() : 0);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::size_t v = vertexOf.at(labels->array->GetVariantValue(row).ToTypeInt64());
    if (isText)
    {
      values.texts[v] = ToText(*found, row);
    }
    else
    {
      values.numbers[v] = vtkDataArray::SafeDownCast(found->array)->GetComponent(row, found->component);
    }
  }
  return values;
}
} // namespace tissue
