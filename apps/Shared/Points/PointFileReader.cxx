/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointFileReader.h"

#include "Shared/Points/DelimitedText.h"
#include "Shared/Points/PlyPoints.h"
#include "Shared/Points/PointTable.h"
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
#include <functional>
#include <stdexcept>

namespace tissue
{
namespace
{
using Fields = std::vector<std::string>;

/** Lines "id,x,y,z,...", after comments that tell the coordinate system. */
PointFile
ReadMarkups(std::istream & stream)
{
  const DelimitedText text = ReadDelimitedText(stream, ',');
  Fields              names;
  PointColumns        columns;
  columns.coordinates = { { 1, 2, 3 } };
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
    file.points.push_back(reader.ReadPoint(record));
    file.places.push_back("line " + std::to_string(record.line));
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

bool
IsTable(const std::string & extension)
{
  const auto extensions = { ".csv", ".tsv", ".tab", ".txt", ".xls", ".dat", ".xyz", ".marker", ".apo" };
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

PointFile
ReadOfFormat(const std::string & extension, const std::string & path, const PointFileOptions & options)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    throw std::runtime_error("no such file, or it cannot be read");
  }
  if (extension == ".vtp")
  {
    return ReadPolyData(path);
  }
  if (extension == ".json")
  {
    return ReadMarkupsJson(stream);
  }
  if (extension == ".ply")
  {
    return ReadPlyPoints(stream);
  }
  return extension == ".fcsv" ? ReadMarkups(stream) : ReadPointTable(stream, options);
}
} // namespace

bool
IsPointFile(const std::string & path)
{
  const std::string extension = ExtensionOf(path);
  return IsTable(extension) || extension == ".fcsv" || extension == ".json" || extension == ".ply" ||
         extension == ".vtp";
}

PointFile
ReadPointFile(const std::string & path, const PointFileOptions & options)
{
  if (std::filesystem::is_directory(path))
  {
    throw std::runtime_error("a folder, not a file of points");
  }
  const std::string extension = ExtensionOf(path);
  if (options.IsOfTables() && !IsTable(extension))
  {
    throw std::runtime_error("--columns, --frame and --firstLine are for tables (.csv, .tsv, .txt, ...)");
  }
  PointFile file = ReadOfFormat(extension, path, options);
  if (options.spacing)
  {
    for (Point & point : file.points)
    {
      std::transform(point.begin(), point.end(), options.spacing->begin(), point.begin(), std::multiplies<>());
    }
    file.unit.clear();
  }
  return file;
}
} // namespace tissue
