/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef MeshFile_h
#define MeshFile_h

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>

namespace tissue
{
/** \brief Reads a mesh by VTK: .vtp, .vtu, .vtk (of any kind), .ply, .stl, or .obj, whose groups are a cell array.
 *
 * The name of a group of .obj is its label, or the labels of both sides: its whole numbers, one or two ("cell_12",
 * "12_15", "12 -1"), are the components of the array GroupLabels, which is absent where a group has no number.
 * \throws std::runtime_error: no such file, not of these formats, damaged. */
vtkSmartPointer<vtkDataSet>
ReadMeshFile(const std::string & path);
} // namespace tissue

#endif
