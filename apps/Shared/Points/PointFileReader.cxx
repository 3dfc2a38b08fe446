/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointFileReader.h"

#include "Shared/Points/DelimitedText.h"
#include "Shared/Points/PointTableReader.h"
#include "Shared/Points/SlicerMarkups.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace tissue
{
namespace
{
using Fields = std::vector<std::string>;

/** The reader of a table whose first line may hold the names of its columns. */
PointTableReader
MakeReader(const DelimitedText::Record & first, bool hasNames)
{
  return AtLine(first.line, [&] {
    if (hasNames)
    {
      return PointTableReader(first.fields, FindPointColumns(first.fields));
    }
    if (first.fields.size() != 3)
    {
      throw std::runtime_error("there are " + std::to_string(first.fields.size()) +
                               " columns and no line of their names before, which only three, x, y and z, can do "
                               "without");
    }
    return PointTableReader({}, PointColumns());
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
  const Fields & first = text.records.front().fields;
  const bool     hasNames = std::none_of(first.begin(), first.end(), [](const auto & f) { return ToNumber(f); });
  const PointTableReader reader = MakeReader(text.records.front(), hasNames);
  for (std::size_t i = hasNames ? 1 : 0; i < text.records.size(); ++i)
  {
    reader.AddPoint(text.records[i], file);
  }
  return file;
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
  PointFile              file;
  const PointTableReader reader(names, columns);
  for (const DelimitedText::Record & record : text.records)
  {
    reader.AddPoint(record, file);
  }
  AtLine(system.line, [&] { TurnIntoLPS(system.text, file.points); });
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
  TurnIntoLPS(SystemOf(reader->GetOutput()), file.points);
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
  return extension == ".csv" || extension == ".fcsv" || extension == ".json" || extension == ".vtp";
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
  if (extension == ".vtp")
  {
    return ReadPolyData(path);
  }
  if (extension == ".json")
  {
    return ReadMarkupsJson(stream);
  }
  return extension == ".fcsv" ? ReadMarkups(stream) : ReadCSV(stream);
}
} // namespace tissue
