/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/VTKFiles.h"

#include "Shared/Files/TableColumns.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVariant.h>
#include <vtkXMLDataObjectWriter.h>
#include <vtkXMLMultiBlockDataWriter.h>
#include <vtkXMLWriter.h>
#include <vtkXMLWriterBase.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace tissue
{
namespace
{
/** Runs a writer of VTK; its errors, which VTK would print and forget, are thrown as std::runtime_error. */
template <typename TWriter>
void
WriteOrThrow(TWriter * writer, const std::string & path)
{
  std::string                errors;
  vtkNew<vtkCallbackCommand> collector;
  collector->SetClientData(&errors);
  collector->SetCallback([](vtkObject *, unsigned long, void * collected, void * message) {
    *static_cast<std::string *>(collected) += static_cast<const char *>(message);
  });
  writer->AddObserver(vtkCommand::ErrorEvent, collector);
  writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, collector);
  writer->SetFileName(path.c_str());
  writer->Write();
  const unsigned long code = writer->GetErrorCode();
  if (code != vtkErrorCode::NoError)
  {
    throw std::runtime_error(vtkErrorCode::GetStringFromErrorCode(code));
  }
  if (!errors.empty())
  {
    throw std::runtime_error(errors);
  }
}

/** In quotes where it must be. */
void
AppendText(std::string & row, const std::string & text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
  {
    row += text;
    return;
  }
  row += '"';
  for (const char c : text)
  {
    row += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  row += '"';
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
void
ClearAllNotes(vtkPointSet * data)
{
  ClearNotes(data->GetPointData());
  ClearNotes(data->GetCellData());
  ClearNotes(data->GetFieldData());
  data->GetPoints()->GetData()->GetInformation()->Clear();
}

void
WriteAppended(vtkXMLWriterBase * writer, vtkDataObject * data, const std::string & path)
{
  writer->SetInputDataObject(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  WriteOrThrow(writer, path);
}
} // namespace

void
WriteBytes(const std::string & bytes, const std::string & path)
{
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << bytes << std::flush;
  if (!file)
  {
    throw std::runtime_error(std::strerror(errno));
  }
}

void
WriteXML(vtkPointSet * data, const std::string & path)
{
  ClearAllNotes(data);
  const auto writer = vtkSmartPointer<vtkXMLWriter>::Take(vtkXMLDataObjectWriter::NewWriter(data->GetDataObjectType()));
  if (!writer)
  {
    throw std::runtime_error(std::string("VTK has no XML format for a ") + data->GetClassName());
  }
  WriteAppended(writer.Get(), data, path);
}

void
WriteXML(vtkMultiBlockDataSet * data, const std::string & path)
{
  for (unsigned int i = 0; i < data->GetNumberOfBlocks(); ++i)
  {
    if (auto * const block = vtkPointSet::SafeDownCast(data->GetBlock(i)))
    {
      ClearAllNotes(block);
    }
  }
  const vtkNew<vtkXMLMultiBlockDataWriter> writer;
  WriteAppended(writer.Get(), data, path);
}

void
WriteStl(vtkPolyData * data, const std::string & path)
{
  const vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(data);
  writer->SetFileTypeToBinary();
  WriteOrThrow(writer.Get(), path);
}

void
WriteCSV(vtkTable * table, const std::string & path)
{
  const std::vector<TableColumn> columns = ListColumns(table);
  std::string                    text;
  for (std::size_t c = 0; c < columns.size(); ++c)
  {
    text += c == 0 ? "" : ",";
    AppendText(text, columns[c].name);
  }
  text += '\n';
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      text += c == 0 ? "" : ",";
      AppendText(text, ToText(columns[c], row));
    }
    text += '\n';
  }
  WriteBytes(text, path);
}

void
WritePNG(vtkImageData * image, const std::string & path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  // Writers of PNG files do not survive a full disk.
  writer->WriteToMemoryOn();
  WriteOrThrow(writer.Get(), path);
  vtkUnsignedCharArray * const bytes = writer->GetResult();
  const unsigned char * const  begin = bytes->GetPointer(0);
  WriteBytes(std::string(begin, begin + bytes->GetNumberOfValues()), path);
}
} // namespace tissue
