/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_KuhnSimplex_h
#define TissueTessellationCore_KuhnSimplex_h

#include "TissueTessellationCore/Common/Types.h"

#include <array>

namespace tissue
{
/** Index of a voxel; of the outside of the image, too. */
using VoxelIndex = std::array<std::int32_t, 3>;

/** \brief A tetrahedron of the Freudenthal-Kuhn subdivision of the grid of voxels.
 *
 * The grid's cubes, whose vertices are the centres of 2x2x2 voxels, are cut into six tetrahedra each, one for each way
 * along three of its edges from its first to its last vertex. All cubes are cut alike, so the tetrahedra fit together.
 *
 * The vertices are in the order of such a way, up to a cyclic permutation: that is all that Pivot() needs. */
struct KuhnSimplex
{
  std::array<VoxelIndex, 4> voxels;

  /** The way from `base` along the axes first, second and the third. */
  static KuhnSimplex
  FromWay(const VoxelIndex & base, int first, int second)
  {
    KuhnSimplex simplex{ { base, base, base, base } };
    simplex.voxels[1][first] += 1;
    simplex.voxels[2][first] += 1;
    simplex.voxels[2][second] += 1;
    simplex.voxels[3] = { { base[0] + 1, base[1] + 1, base[2] + 1 } };
    return simplex;
  }

  /** Becomes the tetrahedron across the triangle opposite to vertex i (M. J. Todd, The Computation of Fixed Points and
   * Applications, 1976): the vertex is mirrored at the middle of its two neighbours in the cyclic order. */
  void
  Pivot(int i)
  {
    const VoxelIndex & before = voxels[(i + 3) % 4];
    const VoxelIndex & after = voxels[(i + 1) % 4];
    for (int axis = 0; axis < 3; ++axis)
    {
      voxels[i][axis] = before[axis] + after[axis] - voxels[i][axis];
    }
  }

  /** The same tetrahedron in every one of its cyclic orders: the first voxel of its way and the axes of the first two
   * steps. */
  struct Key
  {
    VoxelIndex base;
    int        first;
    int        second;
  };

  Key
  GetKey() const
  {
    // The way begins after the one vertex that is not a step, but the whole diagonal, before the next.
    int start = 0;
    while (voxels[(start + 3) % 4][0] - voxels[start][0] != 1 || voxels[(start + 3) % 4][1] - voxels[start][1] != 1 ||
           voxels[(start + 3) % 4][2] - voxels[start][2] != 1)
    {
      ++start;
    }
    return { voxels[start], this->AxisOfStep(start), this->AxisOfStep(start + 1) };
  }

private:
  int
  AxisOfStep(int i) const
  {
    const VoxelIndex & from = voxels[i % 4];
    const VoxelIndex & to = voxels[(i + 1) % 4];
    return to[0] != from[0] ? 0 : to[1] != from[1] ? 1 : 2;
  }
};
} // namespace tissue

#endif
