/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef CellDrawing_h
#define CellDrawing_h

#include "Shared/Pictures/CellColors.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <vector>

namespace tissue
{
/** \brief Collects cells to be drawn: each with a surface of its own, in its colour, and with the outlines of its
 * walls.
 *
 * The mesh has to outlive it and to be sound for RequireConsistentIndices. */
class CellDrawing
{
public:
  CellDrawing(const WallMesh & mesh, VertexId numberOfVertices);

  /** Adds a cell at its place plus `displacement`. */
  void
  Add(VertexId cell, const Point & displacement, const Color & color);

  /** Triangles that face outwards; their cell scalars are colours. */
  vtkPolyData *
  GetSurfaces() const
  {
    return m_Surfaces;
  }

  /** Lines where two walls of a cell meet. */
  vtkPolyData *
  GetOutlines() const
  {
    return m_Outlines;
  }

private:
  /** An edge of a triangle, by its points in ascending order, and the triangle's wall. */
  struct Edge
  {
    vtkIdType low;
    vtkIdType high;
    WallId    wall;
  };

  vtkIdType
  Localize(PointId point, VertexId cell, const Point & displacement);
  void
  AddOutlines();

  const WallMesh & m_Mesh;
  /** Triangles of each cell, as 2 t + s, s being the side of the triangle that the cell is on. */
  std::vector<std::vector<std::size_t>> m_SidesOfCell;
  /** Where each point of the mesh was last drawn, and for which cell. */
  std::vector<vtkIdType>       m_DrawnPoint;
  std::vector<VertexId>        m_DrawnCell;
  std::vector<Edge>            m_Edges;
  vtkNew<vtkUnsignedCharArray> m_Colors;
  vtkNew<vtkPolyData>          m_Surfaces;
  vtkNew<vtkPolyData>          m_Outlines;
};
} // namespace tissue

#endif
