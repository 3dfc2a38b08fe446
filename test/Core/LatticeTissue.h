/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef LatticeTissue_h
#define LatticeTissue_h

#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "VoxelTissue.h"

/** Tissues of known outline, whose cells are Voronoi cells of a displaced lattice. */
namespace tissue_test
{
/** A label volume, what is gathered from it, and its walls. */
struct LatticeTissue
{
  LabelVolume volume;
  JunctionSet junctions;
  WallMesh    mesh;
};

/** The tissue of a volume of this size and place. \param step the lattice's constant, in voxels. \param isInside tells
 * of a voxel and of its cell's seed, both in indices, whether they are in the tissue. */
template <typename TIsInside>
LatticeTissue
MakeLatticeTissue(LabelVolume volume, int step, const TIsInside & isInside,
                  const ReconstructionParameters & parameters = ReconstructionParameters())
{
  // A seed for each step of the lattice and one beyond; the nearest one to a voxel is that of its step or of one next
  // to it.
  std::array<int, 3> count;
  for (int i = 0; i < 3; ++i)
  {
    count[i] = volume.size[i] / step + 3;
  }
  Random             random(7);
  std::vector<Point> seeds(static_cast<std::size_t>(count[0]) * count[1] * count[2]);
  const auto         numberOf = [&](int x, int y, int z) { return (z * count[1] + y) * count[0] + x; };
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    const auto i = static_cast<int>(s);
    const int  place[] = { i % count[0], i / count[0] % count[1], i / count[0] / count[1] };
    for (int axis = 0; axis < 3; ++axis)
    {
      seeds[s][axis] = step * (place[axis] - 0.9 + 0.8 * random.Uniform());
    }
  }
  std::map<int, VertexId> vertexOf;
  std::vector<int>        seedOf;
  for (int z = 0; z < volume.size[2]; ++z)
  {
    for (int y = 0; y < volume.size[1]; ++y)
    {
      for (int x = 0; x < volume.size[0]; ++x)
      {
        const Point p{ { double(x), double(y), double(z) } };
        int         nearest = 0;
        for (int k = 0; k < 27; ++k)
        {
          const int seed = numberOf(x / step + k % 3, y / step + k / 3 % 3, z / step + k / 9);
          nearest = k == 0 || Distance(seeds[seed], p) < Distance(seeds[nearest], p) ? seed : nearest;
        }
        seedOf.push_back(isInside(p, seeds[nearest]) ? nearest : -1);
        if (seedOf.back() >= 0)
        {
          vertexOf[nearest] = 0;
        }
      }
    }
  }
  VertexId last = ExteriorVertex;
  for (auto & entry : vertexOf)
  {
    entry.second = ++last;
  }
  for (const int seed : seedOf)
  {
    volume.vertices.push_back(seed < 0 ? ExteriorVertex : vertexOf[seed]);
  }
  LatticeTissue tissue{ volume, JunctionsOf(volume), {} };
  tissue.mesh = ReconstructTissue(tissue.junctions, parameters, &tissue.volume).walls;
  return tissue;
}

inline LabelVolume
EmptyVolume(const std::array<std::int32_t, 3> & size)
{
  LabelVolume volume;
  volume.size = size;
  return volume;
}

/** Whether a voxel of each cell has the exterior, and not the outside of the volume, for its neighbour, by vertex. */
inline std::vector<bool>
FindCellsAtBackground(const LabelVolume & volume)
{
  std::vector<bool> found(1 + *std::max_element(volume.vertices.begin(), volume.vertices.end()), false);
  for (int i = 0; i < static_cast<int>(volume.vertices.size()); ++i)
  {
    const int place[] = { i % volume.size[0],
                          i / volume.size[0] % volume.size[1],
                          i / volume.size[0] / volume.size[1] };
    for (int k = 0; k < 6; ++k)
    {
      int other[] = { place[0], place[1], place[2] };
      other[k / 2] += k % 2 == 0 ? 1 : -1;
      const bool isInImage = other[k / 2] >= 0 && other[k / 2] < volume.size[k / 2];
      const bool isBackground = isInImage && volume.At(other[0], other[1], other[2]) == ExteriorVertex;
      found[volume.vertices[i]] = found[volume.vertices[i]] || isBackground;
    }
  }
  found[ExteriorVertex] = false;
  return found;
}
} // namespace tissue_test

#endif
