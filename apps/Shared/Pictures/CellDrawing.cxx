/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Pictures/CellDrawing.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <tuple>

namespace tissue
{
CellDrawing::CellDrawing(const WallMesh & mesh, VertexId numberOfVertices)
  : m_Mesh(mesh)
  , m_SidesOfCell(numberOfVertices)
  , m_DrawnPoint(mesh.points.size())
  , m_DrawnCell(mesh.points.size(), ExteriorVertex)
{
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    m_SidesOfCell[cells[0]].push_back(2 * t);
    m_SidesOfCell[cells[1]].push_back(2 * t + 1);
  }
  const vtkNew<vtkPoints>    points;
  const vtkNew<vtkCellArray> triangles;
  const vtkNew<vtkCellArray> lines;
  m_Colors->SetNumberOfComponents(3);
  m_Surfaces->SetPoints(points);
  m_Surfaces->SetPolys(triangles);
  m_Surfaces->GetCellData()->SetScalars(m_Colors);
  m_Outlines->SetPoints(points);
  m_Outlines->SetLines(lines);
}

void
CellDrawing::Add(VertexId cell, const Point & displacement, const Color & color)
{
  m_Edges.clear();
  for (const std::size_t side : m_SidesOfCell[cell])
  {
    const std::array<PointId, 3> & triangle = m_Mesh.triangles[side / 2];
    vtkIdType                      ids[3];
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = this->Localize(triangle[i], cell, displacement);
    }
    for (int i = 0; i < 3; ++i)
    {
      const auto ends = std::minmax(ids[i], ids[(i + 1) % 3]);
      m_Edges.push_back({ ends.first, ends.second, m_Mesh.wallOfTriangle[side / 2] });
    }
    if (side % 2 == 1)
    {
      std::swap(ids[1], ids[2]);
    }
    m_Surfaces->GetPolys()->InsertNextCell(3, ids);
    m_Colors->InsertNextTypedTuple(color.data());
  }
  this->AddOutlines();
}

vtkIdType
CellDrawing::Localize(PointId point, VertexId cell, const Point & displacement)
{
  if (m_DrawnCell[point] != cell)
  {
    const Point & p = m_Mesh.points[point];
    m_DrawnCell[point] = cell;
    m_DrawnPoint[point] =
      m_Surfaces->GetPoints()->InsertNextPoint(p[0] + displacement[0], p[1] + displacement[1], p[2] + displacement[2]);
  }
  return m_DrawnPoint[point];
}

void
CellDrawing::AddOutlines()
{
  std::sort(m_Edges.begin(), m_Edges.end(), [](const Edge & a, const Edge & b) {
    return std::tie(a.low, a.high, a.wall) < std::tie(b.low, b.high, b.wall);
  });
  for (auto first = m_Edges.begin(); first != m_Edges.end();)
  {
    const auto last =
      std::find_if(first, m_Edges.end(), [&](const Edge & e) { return e.low != first->low || e.high != first->high; });
    if (first->wall != (last - 1)->wall)
    {
      m_Outlines->GetLines()->InsertNextCell({ first->low, first->high });
    }
    first = last;
  }
}
} // namespace tissue
