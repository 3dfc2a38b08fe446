/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKComplex_h
#define TissueTessellationVTKComplex_h

#include "TissueTessellationVTK/Arrays.h"

#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkTetra.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace tissue
{
/** \brief Makes a grid of the adjacency complex of a tissue, drawn between the centres of its cells.
 *
 * Point v - 1 is the centre of the cell of vertex v; cells that are in no tetrahedron have one, too. Each tetrahedron
 * of the complex makes one VTK cell, in the order of the complex: a VTK_TETRA, or a VTK_TRIANGLE on the tissue's
 * surface where its fourth vertex is the exterior, which has no position. A tetrahedron's points are listed so that its
 * volume is positive (with combinatorial legality some tetrahedra overlap all the same); a triangle's are in the order
 * of their vertices.
 *
 * | array | of | type, components | meaning |
 * |---|---|---|---|
 * | `Label` (active scalars) | points | Int64, 1 | label of the cell |
 * | `Labels` | cells | Int64, 4 | the four labels in the order of the vertices, so the exterior's is the first |
 *
 * \throws std::invalid_argument for a vertex that `cells` does not have. */
inline vtkSmartPointer<vtkUnstructuredGrid>
MakeComplexGrid(const std::vector<VertexQuadruple> & complex, const std::vector<Cell> & cells)
{
  // The points of all cells come first. Then each tetrahedron has its vertices sorted, which puts the exterior first,
  // and becomes a triangle or a tetrahedron of positive volume.
  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const vtkIdType                      numberOfPoints = cells.empty() ? 0 : static_cast<vtkIdType>(cells.size()) - 1;
  const auto                           points = bridge::MakePoints(numberOfPoints);
  const auto                           label = bridge::MakeArray<bridge::LabelArray>("Label", 1, numberOfPoints);
  for (vtkIdType p = 0; p < numberOfPoints; ++p)
  {
    points->SetPoint(p, cells[p + 1].center.data());
    label->SetValue(p, cells[p + 1].label);
  }

  const vtkIdType numberOfTetrahedra = static_cast<vtkIdType>(complex.size());
  const auto      labels = bridge::MakeArray<bridge::LabelArray>("Labels", 4, numberOfTetrahedra);
  grid->AllocateExact(numberOfTetrahedra, 4 * numberOfTetrahedra);
  for (vtkIdType t = 0; t < numberOfTetrahedra; ++t)
  {
    VertexQuadruple vertices = complex[t];
    std::sort(vertices.begin(), vertices.end());
    vtkIdType ids[4];
    for (int i = 0; i < 4; ++i)
    {
      bridge::RequireVertex(vertices[i], cells, "tetrahedron", static_cast<std::size_t>(t));
      labels->SetTypedComponent(t, i, cells[vertices[i]].label);
      ids[i] = vertices[i] - 1;
    }
    if (vertices[0] == ExteriorVertex)
    {
      grid->InsertNextCell(VTK_TRIANGLE, 3, ids + 1);
      continue;
    }
    double corners[4][3];
    for (int i = 0; i < 4; ++i)
    {
      points->GetPoint(ids[i], corners[i]);
    }
    if (vtkTetra::ComputeVolume(corners[0], corners[1], corners[2], corners[3]) < 0.0)
    {
      std::swap(ids[2], ids[3]);
    }
    grid->InsertNextCell(VTK_TETRA, 4, ids);
  }

  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(label);
  grid->GetCellData()->AddArray(labels);
  return grid;
}
} // namespace tissue

#endif
