/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LabelVolume_h
#define TissueTessellationCore_LabelVolume_h

#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Image/VoxelVertices.h"

#include <cmath>
#include <cstddef>

namespace tissue
{
/** \brief A label image by the vertices of its cells, with its place in physical space. All that is outside of it is
 * exterior. */
struct LabelVolume
{
  std::array<std::int32_t, 3> size = { { 0, 0, 0 } };
  /** The vertex of each voxel, the first axis fastest. */
  VoxelVertices vertices;
  /** The centre of the first voxel. */
  Point origin = { { 0.0, 0.0, 0.0 } };
  /** The step to the next voxel along each axis of the image. */
  std::array<Point, 3> steps = { { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } } };

  VertexId
  At(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    if (x < 0 || y < 0 || z < 0 || x >= size[0] || y >= size[1] || z >= size[2])
    {
      return ExteriorVertex;
    }
    return vertices[(static_cast<std::size_t>(z) * size[1] + y) * size[0] + x];
  }

  /** The index, as a rule not whole, of a physical position. The steps must span a volume. */
  Point
  ToIndex(const Point & position) const
  {
    const Point  offset = position - origin;
    const double volume = Dot(steps[0], Cross(steps[1], steps[2]));
    return (1.0 / volume) * Point{ { Dot(offset, Cross(steps[1], steps[2])),
                                     Dot(offset, Cross(steps[2], steps[0])),
                                     Dot(offset, Cross(steps[0], steps[1])) } };
  }

  /** The edge of a cube that has the volume of a voxel. */
  double
  VoxelLength() const
  {
    return std::cbrt(std::abs(Dot(steps[0], Cross(steps[1], steps[2]))));
  }

  /** The physical position of an index, which need not be whole. */
  Point
  ToPhysical(const Point & index) const
  {
    Point p = origin;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        p[j] += index[i] * steps[i][j];
      }
    }
    return p;
  }
};

} // namespace tissue

#endif
