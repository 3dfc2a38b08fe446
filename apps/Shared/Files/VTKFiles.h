/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef VTKFiles_h
#define VTKFiles_h

#include <string>

class vtkImageData;
class vtkMultiBlockDataSet;
class vtkPointSet;
class vtkPolyData;
class vtkTable;

namespace tissue
{
/** Writes VTK's XML format of the data's type (`.vtp`, `.vtu`): binary, appended, compressed by zlib; the same data
 * give the same bytes. Throws std::runtime_error. */
void
WriteXML(vtkPointSet * data, const std::string & path);

/** Likewise a set of such data (`.vtm`), and each of its blocks in a folder beside it: see
 * OutputFiles::AddWithPieces(). */
void
WriteXML(vtkMultiBlockDataSet * data, const std::string & path);

/** Writes bytes as they are. Throws std::runtime_error. */
void
WriteBytes(const std::string & bytes, const std::string & path);

/** Writes a table of numbers and of text as comma-separated values (TableColumns.h) under a line of the column names,
 * text in quotes where it must be (RFC 4180). Throws std::runtime_error. */
void
WriteCSV(vtkTable * table, const std::string & path);

/** Writes a surface of triangles as binary STL. Throws std::runtime_error. */
void
WriteStl(vtkPolyData * data, const std::string & path);

/** Writes an image of one slice of bytes. Throws std::runtime_error, also where the disk is full. */
void
WritePNG(vtkImageData * image, const std::string & path);
} // namespace tissue

#endif
