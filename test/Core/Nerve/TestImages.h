/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TestImages_h
#define TissueTessellationCore_TestImages_h

#include "Nerve/ImageNerve.h"
#include "TissueTessellationCore/Common/Random.h"

#include <algorithm>

/** Label images of known topology, as what they are: functions of the voxel. */
namespace testing_nerve
{
using namespace tissue;

template <typename TLabel>
LabelVolume
MakeImage(VoxelIndex size, const TLabel & label)
{
  LabelVolume volume;
  volume.size = size;
  for (std::int32_t z = 0; z < size[2]; ++z)
  {
    for (std::int32_t y = 0; y < size[1]; ++y)
    {
      for (std::int32_t x = 0; x < size[0]; ++x)
      {
        volume.vertices.push_back(label(x, y, z));
      }
    }
  }
  return volume;
}

/** One more than the largest vertex. */
inline VertexId
NumberOfVertices(const LabelVolume & volume)
{
  return *std::max_element(volume.vertices.begin(), volume.vertices.end()) + 1;
}

inline ImageNerve
NerveOf(const LabelVolume & volume)
{
  return MakeImageNerve(volume, NumberOfVertices(volume), FindCrowdedBlocks(volume));
}

/** Box-shaped cells of `edge` voxels, `counts` along each axis, numbered from 1, within an image of exterior around.
 * Every second column along the first axis is shifted by half a cell along the second, every second layer along the
 * first two, so that no more than four cells meet. */
inline LabelVolume
Bricks(std::array<std::int32_t, 3> counts, std::int32_t edge, bool isShifted = true)
{
  const std::int32_t margin = edge;
  const VoxelIndex   size{
    { counts[0] * edge + 2 * margin, counts[1] * edge + 2 * margin, counts[2] * edge + 2 * margin }
  };
  return MakeImage(size, [=](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
    const auto         cell = [=](std::int32_t i) { return i < 0 ? -1 : i / edge; };
    const std::int32_t k = cell(z - margin);
    const std::int32_t shift = isShifted && k % 2 != 0 ? edge / 2 : 0;
    const std::int32_t i = cell(x - margin - shift);
    const std::int32_t j = cell(y - margin - shift / 2 - (isShifted && i % 2 != 0 ? edge / 2 : 0));
    return i < 0 || j < 0 || k < 0 || i >= counts[0] || j >= counts[1] || k >= counts[2]
             ? ExteriorVertex
             : 1 + i + counts[0] * (j + counts[1] * k);
  });
}

/** Every voxel of any of the vertices 0 ... numberOfVertices - 1. */
inline LabelVolume
Noise(VoxelIndex size, VertexId numberOfVertices, std::uint64_t seed)
{
  Random random(seed);
  return MakeImage(size, [&](std::int32_t, std::int32_t, std::int32_t) {
    return static_cast<VertexId>(random.Index(static_cast<std::size_t>(numberOfVertices)));
  });
}

/** The Euler characteristic of the boundary of a vertex's region in the Kuhn subdivision of the image, by counting the
 * edges, triangles and tetrahedra that it crosses. */
inline std::int32_t
BoundaryEulerCharacteristic(const LabelVolume & volume, VertexId region)
{
  std::int32_t characteristic = 0;
  const auto   isIn = [&](const VoxelIndex & p) { return volume.At(p[0], p[1], p[2]) == region; };
  // A simplex is a chain of steps by different sets of axes: its first voxel, and an increasing series of sets.
  const auto at = [](const VoxelIndex & p, int set) {
    return VoxelIndex{ { p[0] + (set & 1), p[1] + (set >> 1 & 1), p[2] + (set >> 2 & 1) } };
  };
  for (std::int32_t z = -2; z <= volume.size[2]; ++z)
  {
    for (std::int32_t y = -2; y <= volume.size[1]; ++y)
    {
      for (std::int32_t x = -2; x <= volume.size[0]; ++x)
      {
        const VoxelIndex p{ { x, y, z } };
        const bool       first = isIn(p);
        for (int a = 1; a < 8; ++a)
        {
          const bool second = isIn(at(p, a));
          characteristic += first != second ? 1 : 0;
          for (int b = 1; b < 8; ++b)
          {
            if ((a & b) != a || a == b)
            {
              continue;
            }
            const bool third = isIn(at(p, b));
            characteristic -= first != second || first != third ? 1 : 0;
            if (b != 7)
            {
              const bool fourth = isIn(at(p, 7));
              characteristic += first != second || first != third || first != fourth ? 1 : 0;
            }
          }
        }
      }
    }
  }
  return characteristic;
}
} // namespace testing_nerve

#endif
