/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "PointFile.h"

#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
using Fields = std::vector<std::string>;

std::string
Lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string
Trimmed(const std::string & text)
{
  const char * const blanks = " \t\r\"";
  const auto         begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

Fields
Split(const std::string & line)
{
  const char separator = line.find(',') != std::string::npos ? ',' : line.find(';') != std::string::npos ? ';' : '\t';
  Fields     fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, separator);)
  {
    fields.push_back(Trimmed(field));
  }
  return fields;
}

/** A whole text that is a number, also "nan" and "inf". */
std::optional<double>
ToNumber(const std::string & text)
{
  char *       end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return text.empty() || end != text.c_str() + text.size() ? std::nullopt : std::optional<double>(value);
}

/** Which field holds what. */
struct Columns
{
  std::array<std::size_t, 3> coordinates = { { 0, 1, 2 } };
  std::optional<std::size_t> label;
};

/** The column of an axis: its letter, its letter and a unit, or the letter of a centre. */
bool
IsAxis(const std::string & column, char axis)
{
  const std::string name = Lower(column);
  const bool        hasUnit = name.size() > 1 && name[0] == axis && !std::isalnum(static_cast<unsigned char>(name[1]));
  return name == std::string(1, axis) || hasUnit || name == std::string("center") + axis ||
         name == std::string("center_") + axis;
}

Columns
FindColumns(const Fields & names, const std::string & place)
{
  Columns columns;
  for (int axis = 0; axis < 3; ++axis)
  {
    const char letter = "xyz"[axis];
    const auto at =
      std::find_if(names.begin(), names.end(), [letter](const auto & name) { return IsAxis(name, letter); });
    if (at == names.end())
    {
      throw std::runtime_error(place + ": there is no column " + letter + " among the " + std::to_string(names.size()) +
                               " columns, which must have x, y and z");
    }
    columns.coordinates[axis] = static_cast<std::size_t>(at - names.begin());
  }
  const auto label = std::find_if(names.begin(), names.end(), [](const auto & name) { return Lower(name) == "label"; });
  if (label != names.end())
  {
    columns.label = static_cast<std::size_t>(label - names.begin());
  }
  return columns;
}

const std::string &
FieldAt(const Fields & fields, std::size_t column, const std::string & place)
{
  if (column >= fields.size())
  {
    throw std::runtime_error(place + " has " + std::to_string(fields.size()) + " columns, at least " +
                             std::to_string(column + 1) + " are needed");
  }
  return fields[column];
}

double
CoordinateAt(const Fields & fields, std::size_t column, const std::string & place)
{
  const std::string &         text = FieldAt(fields, column, place);
  const std::optional<double> value = ToNumber(text);
  if (!value)
  {
    throw std::runtime_error(place + ": '" + text + "' in column " + std::to_string(column + 1) + " is no number");
  }
  if (!std::isfinite(*value))
  {
    throw std::runtime_error(place + ": the coordinate in column " + std::to_string(column + 1) + " is " + text +
                             ", must be finite");
  }
  return *value;
}

Label
LabelAt(const Fields & fields, std::size_t column, const std::string & place)
{
  const std::string & text = FieldAt(fields, column, place);
  Label               label = 0;
  const auto          result = std::from_chars(text.data(), text.data() + text.size(), label);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() || label <= 0)
  {
    throw std::runtime_error(place + ": the label '" + text + "' is no whole number above 0");
  }
  return label;
}

void
AddPoint(const Fields & fields, const Columns & columns, const std::string & place, PointFile & file)
{
  Point point{};
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] = CoordinateAt(fields, columns.coordinates[axis], place);
  }
  file.points.push_back(point);
  file.places.push_back(place);
  if (columns.label)
  {
    file.labels.push_back(LabelAt(fields, *columns.label, place));
  }
}

PointFile
ReadCSV(std::istream & stream)
{
  PointFile              file;
  std::optional<Columns> columns;
  int                    number = 0;
  for (std::string line; std::getline(stream, line);)
  {
    const std::string place = "line " + std::to_string(++number);
    const Fields      fields = Split(line);
    if (Trimmed(line).empty() || Trimmed(line)[0] == '#')
    {
      continue;
    }
    const bool isFirst = !columns;
    if (isFirst)
    {
      const bool hasNames = std::none_of(fields.begin(), fields.end(), [](const auto & f) { return ToNumber(f); });
      columns = hasNames ? FindColumns(fields, place) : Columns();
      if (hasNames)
      {
        continue;
      }
    }
    AddPoint(fields, *columns, place, file);
  }
  return file;
}

/** Lines "id,x,y,z,...", after comments that tell the coordinate system. */
PointFile
ReadMarkups(std::istream & stream)
{
  PointFile file;
  Columns   columns{ { { 1, 2, 3 } }, std::nullopt };
  bool      isLPS = false;
  int       number = 0;
  for (std::string line; std::getline(stream, line);)
  {
    const std::string place = "line " + std::to_string(++number);
    const std::string text = Trimmed(line);
    const auto        equals = text.find('=');
    if (text.empty())
    {
      continue;
    }
    if (text[0] != '#')
    {
      AddPoint(Split(line), columns, place, file);
    }
    else if (text.find("CoordinateSystem") != std::string::npos && equals != std::string::npos)
    {
      const std::string system = Trimmed(text.substr(equals + 1));
      if (system != "LPS" && system != "1" && system != "RAS" && system != "0")
      {
        throw std::runtime_error(place + ": the coordinate system '" + system + "' is none of LPS, 1, RAS, 0");
      }
      isLPS = system == "LPS" || system == "1";
    }
    else if (text.find("columns") != std::string::npos && equals != std::string::npos)
    {
      columns.coordinates = FindColumns(Split(text.substr(equals + 1)), place).coordinates;
    }
  }
  for (Point & point : file.points)
  {
    point = isLPS ? point : Point{ { -point[0], -point[1], point[2] } };
  }
  return file;
}

PointFile
ReadPolyData(const std::string & path)
{
  // What is wrong is said in one line, below.
  vtkObject::GlobalWarningDisplayOff();
  const vtkNew<vtkXMLPolyDataReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    throw std::runtime_error("is no VTK file of polygonal data (.vtp)");
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    throw std::runtime_error("is damaged or cut off");
  }
  PointFile file;
  for (vtkIdType i = 0; i < reader->GetOutput()->GetNumberOfPoints(); ++i)
  {
    Point point{};
    reader->GetOutput()->GetPoint(i, point.data());
    const std::string place = "point " + std::to_string(i);
    if (!std::all_of(point.begin(), point.end(), [](double value) { return std::isfinite(value); }))
    {
      throw std::runtime_error(place + " has a coordinate that is not finite");
    }
    file.points.push_back(point);
    file.places.push_back(place);
  }
  return file;
}

std::string
ExtensionOf(const std::string & path)
{
  return Lower(std::filesystem::path(path).extension().string());
}
} // namespace

bool
IsPointFile(const std::string & path)
{
  const std::string extension = ExtensionOf(path);
  return extension == ".csv" || extension == ".fcsv" || extension == ".vtp";
}

PointFile
ReadPointFile(const std::string & path)
{
  if (std::filesystem::is_directory(path))
  {
    throw std::runtime_error("a folder, not a file of points");
  }
  std::ifstream stream(path);
  if (!stream)
  {
    throw std::runtime_error("no such file, or it cannot be read");
  }
  const std::string extension = ExtensionOf(path);
  return extension == ".vtp" ? ReadPolyData(path) : extension == ".fcsv" ? ReadMarkups(stream) : ReadCSV(stream);
}
} // namespace tissue
