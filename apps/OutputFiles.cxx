/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "OutputFiles.h"

#include "WriteOrThrow.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkVariant.h>
#include <vtkXMLDataObjectWriter.h>
#include <vtkXMLWriter.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace tissue
{
namespace
{
namespace fs = std::filesystem;

[[noreturn]] void
Refuse(const std::string & path, const std::string & why)
{
  throw std::runtime_error("Cannot write '" + path + "': " + why);
}

/** A name beside the path that no file has. */
std::string
MakeTemporaryPath(const fs::path & path)
{
  for (int attempt = 0;; ++attempt)
  {
    const std::string name = "." + path.stem().string() + ".part" + std::to_string(attempt) + path.extension().string();
    const fs::path    temporary = path.parent_path() / name;
    std::error_code   error;
    if (!fs::exists(fs::symlink_status(temporary, error)))
    {
      return temporary.string();
    }
  }
}

/** Where the file goes: the path itself, or what it links to. Throws where something else than a file is there. */
fs::path
ResolveTarget(const std::string & path)
{
  std::error_code error;
  fs::path        target = fs::absolute(path, error);
  if (!error)
  {
    target = fs::weakly_canonical(target, error);
  }
  if (error)
  {
    Refuse(path, error.message());
  }
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    Refuse(path, fs::is_directory(status) ? "it is a folder" : "it is not a regular file");
  }
  const fs::path folder = target.parent_path();
  if (!fs::is_directory(folder, error))
  {
    Refuse(path, "there is no folder '" + folder.string() + "'");
  }
  return target;
}

void
RemoveQuietly(const std::string & path)
{
  std::error_code ignored;
  fs::remove(path, ignored);
}

/** Makes an empty file, so that a reason that the folder has against it is known by the system's own word. */
void
CreateEmpty(const std::string & temporaryPath, const std::string & path)
{
  errno = 0;
  std::ofstream file(temporaryPath, std::ios::binary);
  if (!file)
  {
    Refuse(path, std::strerror(errno));
  }
}

void
AppendValue(std::string & row, vtkDataArray * column, vtkIdType index)
{
  if (column->GetDataType() != VTK_DOUBLE)
  {
    row += std::to_string(column->GetVariantValue(index).ToTypeInt64());
    return;
  }
  char       text[32];
  const auto end = std::to_chars(text, text + sizeof(text), column->GetComponent(index, 0)).ptr;
  row.append(text, end);
}
/** Forgets what VTK has noted with the arrays, their ranges: it would be written, or not, by what happened before. */
void
ClearNotes(vtkFieldData * arrays)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    arrays->GetAbstractArray(i)->GetInformation()->Clear();
  }
}
} // namespace

OutputFiles::~OutputFiles()
{
  for (const File & file : m_Files)
  {
    RemoveQuietly(file.temporaryPath);
  }
}

void
OutputFiles::RequireWritable(const std::string & path)
{
  const std::string temporaryPath = MakeTemporaryPath(ResolveTarget(path));
  CreateEmpty(temporaryPath, path);
  RemoveQuietly(temporaryPath);
}

void
OutputFiles::Add(const std::string & path, const Writer & write)
{
  const fs::path target = ResolveTarget(path);
  const File     file{ MakeTemporaryPath(target), target.string() };
  for (const File & other : m_Files)
  {
    if (other.path == file.path)
    {
      Refuse(path, "another output has the same name");
    }
  }
  CreateEmpty(file.temporaryPath, path);
  m_Files.push_back(file);
  try
  {
    write(file.temporaryPath);
  }
  catch (const std::exception & error)
  {
    Refuse(path, error.what());
  }
}

void
OutputFiles::Commit()
{
  for (const File & file : m_Files)
  {
    std::error_code error;
    fs::rename(file.temporaryPath, file.path, error);
    if (error)
    {
      Refuse(file.path, error.message());
    }
  }
  m_Files.clear();
}

void
WriteXML(vtkPointSet * data, const std::string & path)
{
  ClearNotes(data->GetPointData());
  ClearNotes(data->GetCellData());
  ClearNotes(data->GetFieldData());
  data->GetPoints()->GetData()->GetInformation()->Clear();
  const auto writer = vtkSmartPointer<vtkXMLWriter>::Take(vtkXMLDataObjectWriter::NewWriter(data->GetDataObjectType()));
  if (!writer)
  {
    throw std::runtime_error(std::string("VTK has no XML format for a ") + data->GetClassName());
  }
  writer->SetInputDataObject(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  WriteOrThrow(writer.Get(), path);
}

void
WriteCSV(vtkTable * table, const std::string & path)
{
  std::string text;
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
  {
    text += (column == 0 ? "" : ",") + std::string(table->GetColumnName(column));
  }
  text += '\n';
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
    {
      text += column == 0 ? "" : ",";
      AppendValue(text, vtkDataArray::SafeDownCast(table->GetColumn(column)), row);
    }
    text += '\n';
  }
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file)
  {
    throw std::runtime_error(std::strerror(errno));
  }
}
} // namespace tissue
