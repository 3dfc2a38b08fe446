/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PlyPoints.h"

#include "Shared/Points/DelimitedText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
struct Property
{
  std::string type;
  std::string name;
};

/** An element of the header: of how many, and of what each is made. */
struct Element
{
  std::string           name;
  std::size_t           number = 0;
  std::vector<Property> properties;
};

struct Header
{
  std::string          format;
  std::vector<Element> elements;
};

template <typename T>
double
ToDouble(const char * bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return static_cast<double>(value);
}

/** How a number of a type is read from its bytes, in the order of the machine. */
struct NumberType
{
  std::size_t size;
  double (*read)(const char *);
};

/** \throws std::runtime_error for a name of no type, also of lists. */
NumberType
TypeOf(const Property & property)
{
  static const std::map<std::string, NumberType> types{
    { "char", { 1, ToDouble<std::int8_t> } },     { "int8", { 1, ToDouble<std::int8_t> } },
    { "uchar", { 1, ToDouble<std::uint8_t> } },   { "uint8", { 1, ToDouble<std::uint8_t> } },
    { "short", { 2, ToDouble<std::int16_t> } },   { "int16", { 2, ToDouble<std::int16_t> } },
    { "ushort", { 2, ToDouble<std::uint16_t> } }, { "uint16", { 2, ToDouble<std::uint16_t> } },
    { "int", { 4, ToDouble<std::int32_t> } },     { "int32", { 4, ToDouble<std::int32_t> } },
    { "uint", { 4, ToDouble<std::uint32_t> } },   { "uint32", { 4, ToDouble<std::uint32_t> } },
    { "float", { 4, ToDouble<float> } },          { "float32", { 4, ToDouble<float> } },
    { "double", { 8, ToDouble<double> } },        { "float64", { 8, ToDouble<double> } }
  };
  const auto at = types.find(property.type);
  if (at == types.end())
  {
    throw std::runtime_error("the property '" + property.name + "' of the type '" + property.type +
                             "' is not read before the vertices' end");
  }
  return at->second;
}

std::string
ReadLine(std::istream & stream)
{
  std::string line;
  if (!std::getline(stream, line))
  {
    throw std::runtime_error("is cut off");
  }
  if (!line.empty() && line.back() == '\r')
  {
    line.pop_back();
  }
  return line;
}

Header
ReadHeader(std::istream & stream)
{
  if (ReadLine(stream) != "ply")
  {
    throw std::runtime_error("is no PLY: its first line must be 'ply'");
  }
  Header header;
  for (std::string line = ReadLine(stream); line != "end_header"; line = ReadLine(stream))
  {
    std::istringstream words(line);
    std::string        word;
    words >> word;
    if (word == "format")
    {
      words >> header.format;
    }
    else if (word == "element")
    {
      header.elements.emplace_back();
      words >> header.elements.back().name >> header.elements.back().number;
    }
    else if (word == "property" && !header.elements.empty())
    {
      header.elements.back().properties.emplace_back();
      words >> header.elements.back().properties.back().type >> header.elements.back().properties.back().name;
    }
    if (!words)
    {
      throw std::runtime_error("the line '" + line + "' of the header is not that of a PLY");
    }
  }
  return header;
}

/** The values of one element as text. */
std::vector<double>
ReadText(std::istream & stream, std::size_t numberOfProperties)
{
  std::istringstream  words(ReadLine(stream));
  std::vector<double> values;
  for (std::string word; words >> word;)
  {
    const auto value = ToNumber(word);
    if (!value)
    {
      throw std::runtime_error("'" + word + "' is no number");
    }
    values.push_back(*value);
  }
  if (values.size() < numberOfProperties)
  {
    throw std::runtime_error("there are " + std::to_string(values.size()) + " numbers, must be " +
                             std::to_string(numberOfProperties));
  }
  return values;
}

/** The values of one element in bytes, of which the most significant is the first if so said. */
std::vector<double>
ReadBinary(std::istream & stream, const std::vector<Property> & properties, bool isBigEndian)
{
  const std::uint16_t one = 1;
  const bool          isBigEndianMachine = ToDouble<std::uint8_t>(reinterpret_cast<const char *>(&one)) == 0.0;
  std::vector<double> values;
  for (const Property & property : properties)
  {
    const NumberType    type = TypeOf(property);
    std::array<char, 8> bytes{};
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(type.size)))
    {
      throw std::runtime_error("is cut off");
    }
    if (isBigEndian != isBigEndianMachine)
    {
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(type.size));
    }
    values.push_back(type.read(bytes.data()));
  }
  return values;
}

std::size_t
FindProperty(const Element & element, const std::string & name)
{
  const auto at = std::find_if(
    element.properties.begin(), element.properties.end(), [&name](const Property & p) { return p.name == name; });
  if (at == element.properties.end())
  {
    throw std::runtime_error("the vertices have no property " + name);
  }
  return static_cast<std::size_t>(at - element.properties.begin());
}

void
AddVertex(const std::vector<double> & values, const std::array<std::size_t, 3> & columns, PointFile & file)
{
  Point point{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    point[axis] = values[columns[axis]];
    if (!std::isfinite(point[axis]))
    {
      throw std::runtime_error("its " + std::string(1, "xyz"[axis]) + " is " + std::to_string(point[axis]) +
                               ", must be finite");
    }
  }
  file.points.push_back(point);
  file.places.push_back("vertex " + std::to_string(file.points.size() - 1));
}
} // namespace

PointFile
ReadPlyPoints(std::istream & stream)
{
  const Header header = ReadHeader(stream);
  const bool   isText = header.format == "ascii";
  const bool   isBigEndian = header.format == "binary_big_endian";
  if (!isText && !isBigEndian && header.format != "binary_little_endian")
  {
    throw std::runtime_error("the format '" + header.format + "' is none of PLY");
  }
  PointFile file;
  for (const Element & element : header.elements)
  {
    const bool                 isVertex = element.name == "vertex";
    std::array<std::size_t, 3> columns{};
    for (std::size_t axis = 0; isVertex && axis < 3; ++axis)
    {
      columns[axis] = FindProperty(element, std::string(1, "xyz"[axis]));
    }
    for (std::size_t i = 0; i < element.number; ++i)
    {
      try
      {
        const std::vector<double> values =
          isText ? ReadText(stream, element.properties.size()) : ReadBinary(stream, element.properties, isBigEndian);
        if (isVertex)
        {
          AddVertex(values, columns, file);
        }
      }
      catch (const std::runtime_error & error)
      {
        throw std::runtime_error(element.name + " " + std::to_string(i) + ": " + error.what());
      }
    }
    if (isVertex)
    {
      return file;
    }
  }
  throw std::runtime_error("there is no element 'vertex'");
}
} // namespace tissue
