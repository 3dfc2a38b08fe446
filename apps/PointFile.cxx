/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "PointFile.h"

#include "DelimitedText.h"
#include "PointColumns.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace tissue
{
namespace
{
using Fields = std::vector<std::string>;

std::string
PlaceOf(std::size_t line)
{
  return "line " + std::to_string(line);
}

/** What `work` returns; its errors get the line before them. */
template <typename TWork>
auto
AtLine(std::size_t line, const TWork & work)
{
  try
  {
    return work();
  }
  catch (const std::runtime_error & error)
  {
    throw std::runtime_error(PlaceOf(line) + ": " + error.what());
  }
}

/** Adds the points of the lines of a table, which may have names for its columns. */
class TableReader
{
public:
  TableReader(const Fields & names, const PointColumns & columns)
    : m_Names(names)
    , m_Columns(columns)
  {}

  void
  AddPoint(const DelimitedText::Record & record, PointFile & file) const
  {
    AtLine(record.line, [&] {
      Point point{};
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] = this->ReadCoordinate(record.fields, m_Columns.coordinates[axis]);
      }
      file.points.push_back(point);
      file.places.push_back(PlaceOf(record.line));
      if (m_Columns.label)
      {
        file.labels.push_back(this->ReadLabel(record.fields, *m_Columns.label));
      }
    });
  }

private:
  static const std::string &
  FieldAt(const Fields & fields, std::size_t column)
  {
    if (column >= fields.size())
    {
      throw std::runtime_error("there are " + std::to_string(fields.size()) + " columns, at least " +
                               std::to_string(column + 1) + " are needed");
    }
    return fields[column];
  }

  [[noreturn]] void
  Refuse(const std::string & text, std::size_t column, const std::string & why) const
  {
    throw std::runtime_error("'" + text + "' in column " + std::to_string(column + 1) +
                             (column < m_Names.size() ? " ('" + m_Names[column] + "') " : " ") + why);
  }

  double
  ReadCoordinate(const Fields & fields, std::size_t column) const
  {
    const std::string &         text = FieldAt(fields, column);
    const std::optional<double> value = ToNumber(text);
    if (!value)
    {
      this->Refuse(text, column, "is no number");
    }
    if (!std::isfinite(*value))
    {
      this->Refuse(text, column, "must be finite");
    }
    return *value;
  }

  Label
  ReadLabel(const Fields & fields, std::size_t column) const
  {
    const std::string & text = FieldAt(fields, column);
    Label               label = 0;
    const auto          result = std::from_chars(text.data(), text.data() + text.size(), label);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() || label <= 0)
    {
      this->Refuse(text, column, "is no whole number above 0");
    }
    return label;
  }

  Fields       m_Names;
  PointColumns m_Columns;
};

/** The reader of a table whose first line may hold the names of its columns. */
TableReader
MakeReader(const DelimitedText::Record & first, bool hasNames)
{
  return AtLine(first.line, [&] {
    if (hasNames)
    {
      return TableReader(first.fields, FindPointColumns(first.fields));
    }
    if (first.fields.size() != 3)
    {
      throw std::runtime_error("there are " + std::to_string(first.fields.size()) +
                               " columns and no line of their names before, which only three, x, y and z, can do "
                               "without");
    }
    return TableReader({}, PointColumns());
  });
}

PointFile
ReadCSV(std::istream & stream)
{
  const DelimitedText text = ReadDelimitedText(stream);
  PointFile           file;
  if (text.records.empty())
  {
    return file;
  }
  const Fields &    first = text.records.front().fields;
  const bool        hasNames = std::none_of(first.begin(), first.end(), [](const auto & f) { return ToNumber(f); });
  const TableReader reader = MakeReader(text.records.front(), hasNames);
  for (std::size_t i = hasNames ? 1 : 0; i < text.records.size(); ++i)
  {
    reader.AddPoint(text.records[i], file);
  }
  return file;
}

/** Turns points from the system of that name into LPS. */
void
TurnIntoLPS(const std::string & system, PointFile & file)
{
  if (system == "LPS" || system == "1")
  {
    return;
  }
  if (system != "RAS" && system != "0")
  {
    throw std::runtime_error("the coordinate system '" + system + "' is none of LPS, 1, RAS, 0");
  }
  for (Point & point : file.points)
  {
    point = { { -point[0], -point[1], point[2] } };
  }
}

/** Lines "id,x,y,z,...", after comments that tell the coordinate system. */
PointFile
ReadMarkups(std::istream & stream)
{
  const DelimitedText    text = ReadDelimitedText(stream);
  Fields                 names;
  PointColumns           columns{ { { 1, 2, 3 } }, std::nullopt };
  DelimitedText::Comment system{ "RAS", 0 };
  for (const DelimitedText::Comment & comment : text.comments)
  {
    const auto        equals = std::min(comment.text.find('='), comment.text.size());
    const std::string key = TrimBlanks(comment.text.substr(0, equals));
    const std::string value = equals < comment.text.size() ? TrimBlanks(comment.text.substr(equals + 1)) : "";
    if (key == "CoordinateSystem")
    {
      system = { value, comment.line };
    }
    else if (key == "columns")
    {
      names = SplitFields(value);
      // Labels are names there.
      columns.coordinates = AtLine(comment.line, [&] { return FindPointColumns(names).coordinates; });
    }
  }
  PointFile         file;
  const TableReader reader(names, columns);
  for (const DelimitedText::Record & record : text.records)
  {
    reader.AddPoint(record, file);
  }
  AtLine(system.line, [&] { TurnIntoLPS(system.text, file); });
  return file;
}

/** The coordinate system that the data says, as Slicer and our own files do; LPS where it says none. */
std::string
SystemOf(vtkPolyData * data)
{
  auto * const space = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("SPACE"));
  return space != nullptr && space->GetNumberOfValues() > 0 ? space->GetValue(0) : "LPS";
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
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (!std::isfinite(point[axis]))
      {
        throw std::runtime_error(place + ": its " + std::string(1, "xyz"[axis]) + " is " + std::to_string(point[axis]) +
                                 ", must be finite");
      }
    }
    file.points.push_back(point);
    file.places.push_back(place);
  }
  TurnIntoLPS(SystemOf(reader->GetOutput()), file);
  return file;
}

std::string
ExtensionOf(const std::string & path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(
    extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
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
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    throw std::runtime_error("no such file, or it cannot be read");
  }
  const std::string extension = ExtensionOf(path);
  return extension == ".vtp" ? ReadPolyData(path) : extension == ".fcsv" ? ReadMarkups(stream) : ReadCSV(stream);
}
} // namespace tissue
