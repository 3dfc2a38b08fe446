/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LabelVolume_h
#define TissueTessellationCore_LabelVolume_h

#include "TissueTessellationCore/Types.h"

#include <cstddef>
#include <vector>

namespace tissue
{
/** \brief A label image by the vertices of its cells, with its place in physical space. What is outside of it is
 * exterior. */
struct LabelVolume
{
  std::array<std::int32_t, 3> size = { { 0, 0, 0 } };
  /** The vertex of each voxel, the first axis fastest. */
  std::vector<VertexId> vertices;
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
