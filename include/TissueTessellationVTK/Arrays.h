/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKArrays_h
#define TissueTessellationVTKArrays_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>

#include <stdexcept>
#include <string>

namespace tissue
{
/** The helpers that the parts of the VTK bridge share. */
namespace bridge
{
/** The type of the arrays of labels. It has 64 bits, as no narrower type holds every label. */
using LabelArray = vtkTypeInt64Array;

template <typename TArray>
vtkSmartPointer<TArray>
MakeArray(const char * name, int numberOfComponents, vtkIdType numberOfTuples)
{
  vtkSmartPointer<TArray> array = vtkSmartPointer<TArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(numberOfComponents);
  array->SetNumberOfTuples(numberOfTuples);
  return array;
}

/** Makes points of double precision, all of which the caller must set. */
inline vtkSmartPointer<vtkPoints>
MakePoints(vtkIdType numberOfPoints)
{
  vtkSmartPointer<vtkPoints> points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(numberOfPoints);
  return points;
}

/** Says that the coordinates are those of ITK: x to the left, y to the posterior, z to the superior. */
inline void
AddCoordinateSystem(vtkDataObject * data)
{
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue("LPS");
  data->GetFieldData()->AddArray(space);
}

/** Throws std::invalid_argument, which names the owner, where a vertex is none of the cells'. */
inline void
RequireVertex(VertexId vertex, const std::vector<Cell> & cells, const char * owner, std::size_t ownerIndex)
{
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= cells.size())
  {
    throw std::invalid_argument(std::string("VTK bridge: a cell of ") + owner + " " + std::to_string(ownerIndex) +
                                " is " + std::to_string(vertex) + ", must be at least 0 and below " +
                                std::to_string(cells.size()));
  }
}
} // namespace bridge
} // namespace tissue

#endif
