/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/SlicerMarkups.h"

#include "Shared/Files/JsonFiles.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
using Json = nlohmann::json;

/** The text of a key, or what stands for it where it is absent or no text. */
std::string
TextOf(const Json & object, const char * key, const std::string & otherwise)
{
  const auto at = object.find(key);
  return at != object.end() && at->is_string() ? at->get<std::string>() : otherwise;
}

const Json &
ArrayOf(const Json & object, const char * key, const std::string & place)
{
  const auto at = object.is_object() ? object.find(key) : object.end();
  if (!object.is_object() || at == object.end() || !at->is_array())
  {
    throw std::runtime_error(place + " has no list '" + key + "', as markups of 3D Slicer have");
  }
  return *at;
}

Point
ReadPosition(const Json & controlPoint, const std::string & place)
{
  const Json & position = ArrayOf(controlPoint, "position", place);
  Point        point{};
  bool         isPoint = position.size() == 3;
  for (std::size_t axis = 0; isPoint && axis < 3; ++axis)
  {
    isPoint = position[axis].is_number() && std::isfinite(position[axis].get<double>());
    point[axis] = isPoint ? position[axis].get<double>() : 0.0;
  }
  if (!isPoint)
  {
    throw std::runtime_error(place + ": its position is " + position.dump() + ", must be three finite numbers");
  }
  return point;
}

/** Whether a point has a place: those of other states are there to be placed, or are not to be. */
bool
IsPlaced(const Json & controlPoint, const std::string & place)
{
  const std::string status = TextOf(controlPoint, "positionStatus", "defined");
  if (status != "defined" && status != "undefined" && status != "preview" && status != "missing")
  {
    throw std::runtime_error(place + ": its positionStatus is '" + status +
                             "', must be defined, undefined, preview or missing");
  }
  return status == "defined";
}

void
AddMarkup(const Json & markup, const std::string & place, PointFile & file)
{
  const Json &      controlPoints = ArrayOf(markup, "controlPoints", place);
  const std::string type = TextOf(markup, "type", "");
  if (type != "Fiducial")
  {
    throw std::runtime_error(place + " is of the type '" + type + "', must be Fiducial: a list of points");
  }
  std::vector<Point> points;
  std::size_t        number = 0;
  for (const Json & controlPoint : controlPoints)
  {
    const std::string placeOfPoint = place + ", point " + std::to_string(++number);
    if (IsPlaced(controlPoint, placeOfPoint))
    {
      points.push_back(ReadPosition(controlPoint, placeOfPoint));
      file.places.push_back(placeOfPoint);
    }
  }
  if (points.size() < number)
  {
    file.warnings.push_back(place + ": " + std::to_string(number - points.size()) + " of " + std::to_string(number) +
                            " points have no place and are left out");
  }
  try
  {
    TurnIntoLPS(TextOf(markup, "coordinateSystem", ""), points);
  }
  catch (const std::runtime_error & error)
  {
    throw std::runtime_error(place + ": " + error.what());
  }
  file.points.insert(file.points.end(), points.begin(), points.end());
}

/** "scale 1.5, radius 2.6" of the columns but `Label`. */
std::string
DescribePoint(const PointTable & table, std::size_t i)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  for (const auto & [name, values] : table.columns)
  {
    if (name != "Label")
    {
      text << (text.tellp() > 0 ? ", " : "") << name << ' ' << values[i];
    }
  }
  return text.str();
}

nlohmann::ordered_json
ToControlPoint(const PointTable & table, std::size_t i)
{
  const auto * const labels = table.FindColumn("Label");
  const Label        label = labels != nullptr ? static_cast<Label>((*labels)[i]) : static_cast<Label>(i + 1);
  return { { "id", std::to_string(i + 1) },
           { "label", std::to_string(label) },
           { "description", DescribePoint(table, i) },
           { "associatedNodeID", "" },
           { "position", table.points[i] },
           // Slicer's own for points without an orientation: the axes of RAS in LPS.
           { "orientation", { -1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0 } },
           { "selected", true },
           { "locked", false },
           { "visibility", true },
           { "positionStatus", "defined" } };
}
} // namespace

PointFile
ReadMarkupsJson(std::istream & stream)
{
  Json json;
  try
  {
    json = Json::parse(stream);
  }
  catch (const Json::exception & error)
  {
    const std::string text = error.what();
    throw std::runtime_error("is no JSON: " + text.substr(text.find(']') + 2));
  }
  PointFile file;
  int       number = 0;
  for (const Json & markup : ArrayOf(json, "markups", "the file"))
  {
    AddMarkup(markup, "markup " + std::to_string(++number), file);
  }
  return file;
}

void
WriteMarkupsJson(const PointTable & table, const std::string & path)
{
  auto controlPoints = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < table.points.size(); ++i)
  {
    controlPoints.push_back(ToControlPoint(table, i));
  }
  const nlohmann::ordered_json markup = { { "type", "Fiducial" },
                                          { "coordinateSystem", "LPS" },
                                          { "locked", false },
                                          { "labelFormat", "%N-%d" },
                                          { "lastUsedControlPointNumber", table.points.size() },
                                          { "controlPoints", controlPoints } };
  // The schema is a name: Slicer looks at its version alone.
  WriteJson({ { "@schema",
                "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
                "markups-schema-v1.0.3.json#" },
              { "markups", nlohmann::ordered_json::array({ markup }) } },
            path);
}

void
TurnIntoLPS(const std::string & system, std::vector<Point> & points)
{
  if (system == "LPS" || system == "1")
  {
    return;
  }
  if (system != "RAS" && system != "0")
  {
    throw std::runtime_error("the coordinate system '" + system + "' is none of LPS, 1, RAS, 0");
  }
  for (Point & point : points)
  {
    point = { { -point[0], -point[1], point[2] } };
  }
}
} // namespace tissue
