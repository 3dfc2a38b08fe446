/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "VoxelDice.h"

#include <vtkCellArray.h>
#include <vtkImageStencilData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataToImageStencil.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tissue
{
namespace
{
/** A cell's triangles, outwards, in the coordinates of the voxels' indices. */
class CellSurfaceInVoxels
{
public:
  CellSurfaceInVoxels(const WallMesh & walls, const std::vector<Point> & indices, VertexId cell,
                      const std::vector<std::size_t> & triangles)
  {
    const vtkNew<vtkPoints>    points;
    const vtkNew<vtkCellArray> polygons;
    points->SetDataTypeToDouble();
    for (const std::size_t t : triangles)
    {
      const bool isFirst = walls.walls[walls.wallOfTriangle[t]].cells[0] == cell;
      polygons->InsertNextCell(3);
      for (int i = 0; i < 3; ++i)
      {
        // Each triangle with points of its own: the stencil joins them by their places.
        const Point & p = indices[walls.triangles[t][isFirst ? i : 2 - i]];
        polygons->InsertCellPoint(points->InsertNextPoint(p.data()));
      }
    }
    m_Surface->SetPoints(points);
    m_Surface->SetPolys(polygons);
  }

  /** The box of voxels that can be within. */
  void
  GetExtent(const std::array<std::int32_t, 3> & size, int extent[6]) const
  {
    double bounds[6];
    m_Surface->GetBounds(bounds);
    for (int axis = 0; axis < 3; ++axis)
    {
      extent[2 * axis] = std::max(0, static_cast<int>(std::floor(bounds[2 * axis])));
      extent[2 * axis + 1] = std::min(size[axis] - 1, static_cast<int>(std::ceil(bounds[2 * axis + 1])));
    }
  }

  vtkPolyData *
  Get() const
  {
    return m_Surface;
  }

private:
  vtkNew<vtkPolyData> m_Surface;
};

/** Counts the voxels within the surface, and those of them that are the cell's. */
void
CountVoxels(const CellSurfaceInVoxels & surface, const LabelVolume & labels, VertexId cell, std::int64_t & inMesh,
            std::int64_t & common)
{
  int extent[6];
  surface.GetExtent(labels.size, extent);
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return;
  }
  const vtkNew<vtkPolyDataToImageStencil> stencil;
  stencil->SetInputData(surface.Get());
  stencil->SetOutputOrigin(0.0, 0.0, 0.0);
  stencil->SetOutputSpacing(1.0, 1.0, 1.0);
  stencil->SetOutputWholeExtent(extent);
  // VTK widens the voxels by default, so that a voxel at a wall is in both its cells.
  stencil->SetTolerance(0.0);
  stencil->Update();
  vtkImageStencilData * const inside = stencil->GetOutput();
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      const VertexId * const row =
        labels.vertices.data() + (static_cast<std::size_t>(z) * labels.size[1] + y) * labels.size[0];
      int begin = 0;
      int end = 0;
      int iterator = 0;
      while (inside->GetNextExtent(begin, end, extent[0], extent[1], y, z, iterator))
      {
        inMesh += end - begin + 1;
        common += std::count(row + begin, row + end + 1, cell);
      }
    }
  }
}

std::vector<std::int64_t>
CountVoxelsOfImage(VertexId numberOfVertices, const LabelVolume & labels)
{
  std::vector<std::int64_t> counts(static_cast<std::size_t>(numberOfVertices), 0);
  for (const VertexId v : labels.vertices)
  {
    if (v < numberOfVertices) // voids come after the cells
    {
      ++counts[v];
    }
  }
  return counts;
}
} // namespace

std::vector<double>
ComputeVoxelDice(const WallMesh & walls, VertexId numberOfVertices, const LabelVolume & labels)
{
  std::vector<Point> indices(walls.points.size());
  std::transform(walls.points.begin(), walls.points.end(), indices.begin(), [&labels](const Point & p) {
    return labels.ToIndex(p);
  });
  std::vector<std::vector<std::size_t>> trianglesOfCell(static_cast<std::size_t>(numberOfVertices));
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    for (const VertexId v : walls.walls[walls.wallOfTriangle[t]].cells)
    {
      if (v != ExteriorVertex && v < numberOfVertices)
      {
        trianglesOfCell[v].push_back(t);
      }
    }
  }
  const std::vector<std::int64_t> inImage = CountVoxelsOfImage(numberOfVertices, labels);
  std::vector<double>             dice(static_cast<std::size_t>(numberOfVertices), 0.0);
  for (VertexId v = ExteriorVertex + 1; v < numberOfVertices; ++v)
  {
    if (!trianglesOfCell[v].empty())
    {
      std::int64_t inMesh = 0;
      std::int64_t common = 0;
      CountVoxels(CellSurfaceInVoxels(walls, indices, v, trianglesOfCell[v]), labels, v, inMesh, common);
      const std::int64_t both = inMesh + inImage[v];
      dice[v] = both > 0 ? 2.0 * static_cast<double>(common) / static_cast<double>(both) : 0.0;
    }
  }
  return dice;
}
} // namespace tissue
