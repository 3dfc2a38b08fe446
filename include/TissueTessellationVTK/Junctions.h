/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKJunctions_h
#define TissueTessellationVTKJunctions_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationVTK/Arrays.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkTable.h>

namespace tissue
{
/** \brief Makes a table of the junctions of a label image, with one row for each four cells that meet, as in Junction.
 *
 * The columns are `Label0` .. `Label3` (Int64, in the order of the vertices, so that the exterior comes first, and a
 * void, which has the exterior's label, last), `X`, `Y`, `Z` (Float64, physical), `NumberOfBlocks`,
 * `NumberOfExactBlocks`, `NumberOfClusters` (Int64). */
inline vtkSmartPointer<vtkTable>
MakeJunctionTable(const JunctionSet & junctions)
{
  // The columns of the labels come first, then those of the position, then the counts.
  const auto                rows = static_cast<vtkIdType>(junctions.junctions.size());
  vtkSmartPointer<vtkTable> table = vtkSmartPointer<vtkTable>::New();
  const auto                addIntegers = [&](const std::string & name, auto valueOf) {
    const auto column = bridge::MakeArray<vtkTypeInt64Array>(name.c_str(), 1, rows);
    for (vtkIdType row = 0; row < rows; ++row)
    {
      column->SetValue(row, valueOf(junctions.junctions[row]));
    }
    table->GetRowData()->AddArray(column);
  };
  for (int i = 0; i < 4; ++i)
  {
    addIntegers("Label" + std::to_string(i),
                [&junctions, i](const Junction & junction) { return junctions.cells[junction.cells[i]].label; });
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const char * const names[] = { "X", "Y", "Z" };
    const auto         column = bridge::MakeArray<vtkDoubleArray>(names[axis], 1, rows);
    for (vtkIdType row = 0; row < rows; ++row)
    {
      column->SetValue(row, junctions.junctions[row].position[axis]);
    }
    table->GetRowData()->AddArray(column);
  }
  addIntegers("NumberOfBlocks", [](const Junction & junction) { return junction.numberOfBlocks; });
  addIntegers("NumberOfExactBlocks", [](const Junction & junction) { return junction.numberOfExactBlocks; });
  addIntegers("NumberOfClusters",
              [](const Junction & junction) { return static_cast<std::int64_t>(junction.numberOfClusters); });
  return table;
}
} // namespace tissue

#endif
