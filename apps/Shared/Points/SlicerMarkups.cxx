/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/SlicerMarkups.h"

#include <nlohmann/json.hpp>

#include <cmath>
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
  const Json &      position = ArrayOf(controlPoint, "position", place);
  const std::string status = TextOf(controlPoint, "positionStatus", "defined");
  if (status != "defined")
  {
    throw std::runtime_error(place + ": its position is '" + status + "', must be defined");
  }
  Point point{};
  bool  isPoint = position.size() == 3;
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
  for (const Json & controlPoint : controlPoints)
  {
    file.places.push_back(place + ", point " + std::to_string(points.size() + 1));
    points.push_back(ReadPosition(controlPoint, file.places.back()));
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
