/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Pictures/PictureView.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
/** How far above the horizon the viewer stands, as a height for each unit along both sides. */
constexpr double elevation = 0.9;
/** How much more of the free surface, as a part of it, has to face a direction to be preferred. */
constexpr double minimalOpenness = 0.01;
/** Space between two drawings, as a part of their widths. */
constexpr double gapRatio = 0.06;

/** Each piece of the free surface counts by how much it faces away from the tissue's centre: the smooth round tip of a
 * tissue more than a flat, hollow or ragged base, and what the border of the image cut off not at all. */
Vector
FindTissueAxis(const WallMesh & mesh, const std::vector<Cell> & cells, const Point & center)
{
  Vector sum{};
  double totalArea = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const VertexPair & pair = mesh.walls[mesh.wallOfTriangle[t]].cells;
    if (pair[1] != ExteriorVertex || cells[pair[0]].touchesBorder)
    {
      continue;
    }
    const Triangle & triangle = mesh.triangles[t];
    const Point &    corner = mesh.points[triangle[0]];
    const Vector     normal = Cross(mesh.points[triangle[1]] - corner, mesh.points[triangle[2]] - corner);
    sum = sum + Dot(Normalized(normal), Normalized(corner - center)) * normal;
    totalArea += Norm(normal);
  }
  // A ball or a block has no tip: then the last axis, as where two axes are about as good.
  std::size_t largest = 2;
  for (std::size_t i = 0; i < 2; ++i)
  {
    if (std::abs(sum[i]) > std::abs(sum[largest]) + minimalOpenness * totalArea)
    {
      largest = i;
    }
  }
  Vector axis{};
  axis[largest] = sum[largest] < -minimalOpenness * totalArea ? -1.0 : 1.0;
  return axis;
}
} // namespace

PictureView
ChooseView(const WallMesh & mesh, const std::vector<Cell> & cells, const Point & center)
{
  PictureView  view;
  const Vector axis = FindTissueAxis(mesh, cells, center);
  auto & [sideA, sideB] = view.sides;
  auto & [right, up, toViewer] = view.axes;
  sideA = { { axis[2], axis[0], axis[1] } };
  sideB = Cross(axis, sideA);
  toViewer = Normalized(sideA + sideB + elevation * axis);
  right = Normalized(Cross(axis, toViewer));
  up = Cross(toViewer, right);
  return view;
}

ViewBox
FindBox(const PictureView & view, vtkPolyData * data)
{
  ViewBox box{ { { HUGE_VAL, HUGE_VAL, HUGE_VAL } }, { { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } } };
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    Point point;
    data->GetPoint(p, point.data());
    for (int i = 0; i < 3; ++i)
    {
      const double coordinate = Dot(view.axes[i], point);
      box.low[i] = std::min(box.low[i], coordinate);
      box.high[i] = std::max(box.high[i], coordinate);
    }
  }
  return box;
}

PictureLayout
PlaceSideBySide(const PictureView & view, const ViewBox & left, const ViewBox & right)
{
  PictureLayout layout{};
  const double  drawn = left.Size(0) + right.Size(0);
  layout.size = {
    { drawn + gapRatio * drawn, std::max(left.Size(1), right.Size(1)), std::max(left.Size(2), right.Size(2)) }
  };
  layout.leftPosition = (-0.5 * layout.size[0] - left.low[0]) * view.axes[0];
  layout.rightPosition = (0.5 * layout.size[0] - right.high[0]) * view.axes[0];
  for (int i = 1; i < 3; ++i)
  {
    layout.leftPosition = layout.leftPosition + -0.5 * (left.low[i] + left.high[i]) * view.axes[i];
    layout.rightPosition = layout.rightPosition + -0.5 * (right.low[i] + right.high[i]) * view.axes[i];
  }
  return layout;
}
} // namespace tissue
